/* Options, INI files, frames and names: each rule of section 2 of
 * tests/povray.md that needs no picture. Runs in a directory of its own. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "base/text.h"
#include "cli/option.h"
#include "cli/output_name.h"

static char directory[] = "/tmp/glim-options-XXXXXX";

static void put(const char *name, const char *text)
{
    FILE *file = fopen(name, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static int setup(void **state)
{
    (void)state;
    if (!mkdtemp(directory) || chdir(directory) != 0)
        return -1;
    setenv("HOME", directory, 1);
    unsetenv("POVINI");
    put("povray.ini", ""); /* hides the machine's own */
    put("scene.pov", "");
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    char command[100];
    snprintf(command, sizeof command, "rm -r %s", directory);
    return chdir("/") == 0 && system(command) == 0 ? 0 : -1;
}

/* What became of a command line, until the next call. */
static struct result {
    struct options o;
    bool good;
    unsigned errors, warnings;
    char text[2000]; /* the messages */
    struct arena *arena;
} result;

/* `line` is split at blanks. */
static struct result *run(const char *line)
{
    static char name[] = "glim", copy[1000];
    char *words[100] = { name };
    int count = 1;
    snprintf(copy, sizeof copy, "%s", line);
    for (char *word = strtok(copy, " "); word && count < 100;
         word = strtok(NULL, " "))
        words[count++] = word;
    arena_free(result.arena);
    memset(&result, 0, sizeof result);
    result.arena = arena_new(0);
    FILE *out = fmemopen(result.text, sizeof result.text, "w");
    struct diag diag = diag_new();
    diag.out = out;
    result.good = options_parse(&result.o, count, words, result.arena, &diag);
    fclose(out);
    result.errors = diag.errors;
    result.warnings = diag.warnings;
    return &result;
}

/* The options of a line that must be right. */
static struct options *good(const char *line)
{
    run(line);
    if (!result.good || result.errors)
        fail_msg("%s: %s", line, result.text);
    return &result.o;
}

static void bad(const char *line, const char *message)
{
    run(line);
    if (result.good || strcmp(result.text, message) != 0)
        fail_msg("%s:\n  got    %s  wanted %s", line, result.text, message);
}

static void defaults_are_povrays(void **state)
{
    (void)state;
    struct options *o = good("scene.pov");
    assert_string_equal(o->input, "scene.pov");
    assert_string_equal(o->output, "scene.png");
    assert_int_equal(o->render.width, 800);
    assert_int_equal(o->render.height, 600);
    assert_int_equal(o->render.column_end, 800);
    assert_int_equal(o->render.row_end, 600);
    assert_false(o->render.antialias);
    assert_float_equal(o->render.threshold, 0.3, 0);
    assert_float_equal(o->render.jitter, 1, 0);
    assert_int_equal(o->render.depth, 3);
    assert_int_equal(o->quality, 9);
    assert_false(o->frames.animated);
    assert_false(o->parse.clock_on);
    assert_string_equal(o->lighting->name, "mesh");
}

static void switches_take_either_sign_and_case(void **state)
{
    (void)state;
    assert_int_equal(good("scene.pov +W640 -h480")->render.height, 480);
    assert_int_equal(result.o.render.width, 640);
    assert_int_equal(good("scene.pov WIDTH=32 height=7.9")->render.height, 7);
    assert_true(good("scene.pov +A0.1 +R4 +AM2")->render.antialias);
    assert_float_equal(result.o.render.threshold, 0.1, 0);
    assert_int_equal(result.o.render.depth, 4);
    assert_int_equal(result.o.render.method, 2);
    assert_false(good("scene.pov +A0.1 -A")->render.antialias);
    assert_float_equal(good("scene.pov +A +J0.5")->render.jitter, 0.5, 0);
    assert_float_equal(good("scene.pov +A -J")->render.jitter, 0, 0);
    assert_true(good("scene.pov +C +UA")->alpha);
    assert_int_equal(good("+Iscene -V")->progress, PROGRESS_NEVER);
    assert_float_equal(good("+Iscene File_Gamma=2.2")->file_gamma, 2.2, 0);
    assert_int_equal(result.o.action, ACTION_RENDER);
    assert_int_equal(good("+Iscene +WT3")->render.threads, 3);
    assert_int_equal(good("+Iscene --threads 5")->render.threads, 5);
    assert_int_equal(good("+Iscene --threads=6")->render.threads, 6);
}

static void the_last_wins_but_not_of_declares(void **state)
{
    (void)state;
    put("a.ini", "Width=20 ; a comment\n+H10 +FT\nDeclare=A=1\n");
    struct options *o = good("+W5 a.ini +H7 Declare=A=2 Declare=B=x scene.pov");
    assert_int_equal(o->render.width, 20);
    assert_int_equal(o->render.height, 7);
    assert_int_equal(o->file_type, 'T');
    assert_int_equal(o->parse.declare_count, 2);
    assert_string_equal(o->parse.declares[0].value, "1");
    assert_non_null(o->parse.declares[0].span.source);
    assert_string_equal(o->parse.declares[1].name, "B");
    assert_null(o->parse.declares[1].span.source);
    put("other.pov", "");
    assert_string_equal(good("scene.pov other.pov")->input, "other.pov");
}

static void ini_files_have_sections_and_comments(void **state)
{
    (void)state;
    put("s.ini", "# one\n;two\n  Width = 30 # three\r\n\n"
                 "Output_File_Name=\"my file;x\" ; four\n"
                 "[ a ]\nHeight=11\n[b]\nHeight=12\n[A]\nWidth=13\n"
                 "[glim]\nQuality=4\n");
    struct options *o = good("s.ini scene.pov");
    assert_int_equal(o->render.width, 30);
    assert_int_equal(o->render.height, 600);
    assert_int_equal(o->quality, 4);
    assert_string_equal(o->output, "my file;x.png");
    assert_int_equal(good("s[a] scene.pov")->render.height, 11);
    assert_int_equal(result.o.render.width, 13);
    assert_int_equal(good("s.ini[B] scene.pov")->render.height, 12);
}

static void ini_files_are_found_along_the_library(void **state)
{
    (void)state;
    assert_int_equal(system("mkdir -p lib"), 0);
    put("lib/l.ini", "Width=21\nInput_File_Name=in\n");
    put("lib/in.pov", "");
    struct options *o = good("+Llib l.ini");
    assert_int_equal(o->render.width, 21);
    assert_string_equal(o->path, "lib/in.pov");
    assert_string_equal(o->output, "in.png");
    assert_string_equal(o->parse.include_paths[0], "lib");
}

static void start_up_files_are_two_at_most(void **state)
{
    (void)state;
    put("povray.ini", "Width=40\nHeight=30\nVerbose=On\nDisplay=On\n");
    struct options *o = good("scene.pov");
    assert_int_equal(o->render.width, 40);
    assert_int_equal(o->progress, PROGRESS_TERMINAL);
    put(".glim.ini", "Width=41\n");
    assert_int_equal(good("scene.pov")->render.width, 41);
    put("glim.ini", "Width=42\n");
    assert_int_equal(good("scene.pov")->render.width, 42);
    assert_int_equal(result.o.render.height, 30);
    put("other.ini", "Height=31\n");
    setenv("POVINI", "other.ini", 1);
    assert_int_equal(good("scene.pov")->render.height, 31);
    unsetenv("POVINI");
    unlink("glim.ini");
    unlink(".glim.ini");
    put("povray.ini", "");
}

static void names_follow_povray(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    static const struct {
        const char *output, *input;
        char type;
        const char *name;
    } cases[] = {
        { NULL, "x.pov", 'N', "x.png" },
        { NULL, "x", 'J', "x.jpg" },
        { NULL, "sub/y.pov", 'N', "sub/y.png" },
        { NULL, "a.b.pov", 'N', "a.b.png" },
        { NULL, "z.inc", 'E', "z.exr" },
        { "y", "x.pov", 'N', "y.png" },
        { "dir/", "sub/x.pov", 'N', "dir/x.png" },
        { "dir/q", "x.pov", 'T', "dir/q.tga" },
        { "q.png", "x.pov", 'N', "q.png" },
        { "q.PNG", "x.pov", 'N', "q.PNG.png" },
        { "q.tga", "x.pov", 'N', "q.tga.png" },
        { "q.tga", "x.pov", 'C', "q.tga" },
        { "d.x/q", "x.pov", 'B', "d.x/q.bmp" },
        { "-", "x.pov", 'N', "-" },
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_string_equal(output_name(cases[i].output, cases[i].input,
                                        output_type_find(cases[i].type), arena),
                            cases[i].name);
    assert_int_equal(output_type_meant("a.JPG", output_type_find('n'))->letter,
                     'J');
    arena_free(arena);
}

static void file_types_have_depth_and_grey(void **state)
{
    (void)state;
    good("scene.pov +FN16");
    assert_int_equal(options_format(&result.o).bits, 16);
    good("scene.pov +fng");
    assert_int_equal(options_format(&result.o).bits, 16);
    assert_true(options_format(&result.o).grey);
    good("scene.pov +FN8g");
    assert_int_equal(options_format(&result.o).bits, 8);
    good("scene.pov +FJ90 Compression=70");
    assert_int_equal(options_format(&result.o).quality, 70);
    assert_string_equal(result.o.output, "scene.jpg");
    assert_null(good("scene.pov -F")->output);
    good("scene.pov Output_File_Type=t");
    assert_string_equal(result.o.output, "scene.tga");
    bad("scene.pov +FN32",
        "glim: error: 32 bits are too many: PNG and PPM files have 1 to 16; "
        "floats are written by +FE32\n");
}

static void parts_count_from_one_or_are_shares(void **state)
{
    (void)state;
    struct render_options *r =
        &good("scene.pov +W16 +H48 +SC5 +EC8 +SR0.33 +ER0.67")->render;
    assert_int_equal(r->column_start, 4);
    assert_int_equal(r->column_end, 8);
    assert_int_equal(r->row_start, 15);
    assert_int_equal(r->row_end, 32);
    r = &good("scene.pov +W16 +H48 +SC1 +EC1 +SR0")->render;
    assert_int_equal(r->column_start, 0);
    assert_int_equal(r->column_end, 16);
    assert_int_equal(r->row_start, 0);
    bad("scene.pov +W16 +EC17",
        "glim: error: End_Column must not be beyond 16, the picture's last\n");
    bad("scene.pov +H16 +SR17",
        "glim: error: Start_Row must not be beyond 16, the picture's last\n");
    bad("scene.pov +SC5 +EC3",
        "glim: error: End_Column 3 is before Start_Column 5\n");
}

/* The frames of `line` as "number:clock name" joined by blanks. */
static void frames_are(const char *line, const char *wanted)
{
    struct options *o = good(line);
    char text[400] = "";
    for (int i = 0; i < frames_count(&o->frames); i++) {
        int number = frames_number(&o->frames, i);
        struct parse_options parse = o->parse;
        frames_tell(&o->frames, number, &parse);
        size_t used = strlen(text);
        snprintf(text + used, sizeof text - used, "%s%d:%.4g=%s", i ? " " : "",
                 parse.frame_number, parse.clock,
                 frames_name(&o->frames, number, o->output, result.arena));
    }
    assert_string_equal(text, wanted);
}

static void frames_are_povrays(void **state)
{
    (void)state;
    frames_are("scene.pov", "0:0=scene.png");
    frames_are("scene.pov +K2.5 +KF9", "0:2.5=scene.png");
    assert_true(result.o.parse.clock_on);
    frames_are("scene.pov +KFF3 +Oa.png", "1:0=a1.png 2:0.5=a2.png 3:1=a3.png");
    frames_are("scene.pov +KFF3 +KI2 +KF4 +KC",
               "1:2=scene1.png 2:2.667=scene2.png 3:3.333=scene3.png");
    frames_are("scene.pov +KFF9 +KC +EF1", "1:0=scene01.png");
    frames_are("scene.pov +KFI3", "3:0=scene3.png");
    frames_are("scene.pov +KFI3 +KFF3 +KI5", "3:5=scene3.png");
    frames_are("scene.pov +KFF0", "0:0=scene.png");
    frames_are("scene.pov +KFI0 +KFF1 +O-", "0:0=- 1:1=-");
    frames_are("scene.pov +KFI98 +KFF101 +SF0.25",
               "98:0=scene098.png 99:0.3333=scene099.png "
               "100:0.6667=scene100.png 101:1=scene101.png");
    frames_are("scene.pov +KFF10 +SF0.25 +EF0.5",
               "2:0.1111=scene02.png 3:0.2222=scene03.png "
               "4:0.3333=scene04.png 5:0.4444=scene05.png");
    frames_are("scene.pov +KFF10 +STP4 +SF2",
               "2:0.1111=scene02.png 6:0.5556=scene06.png "
               "10:1=scene10.png");
    frames_are("scene.pov +KFF3 +STP-2", "3:1=scene3.png 1:0=scene1.png");
    frames_are("scene.pov +KFF3 +EF4 +SF3", "3:1=scene3.png 4:1.5=scene4.png");
    bad("scene.pov +KFI5 +KFF2",
        "glim: error: Final_Frame 2 is before Initial_Frame 5\n");
    bad("scene.pov +KFF9 +SF3 +EF2",
        "glim: error: Subset_End_Frame 2 is before Subset_Start_Frame 3\n");
}

static void errors_say_what_to_type(void **state)
{
    (void)state;
    bad("", "glim: error: no scene given: type glim scene.pov, or glim "
            "--help\n");
    bad("scene", "glim: error: there is no INI file 'scene.ini': to render "
                 "the scene type scene.pov\n");
    bad("scene.pov +Widht=3", "glim: error: unknown option '+Widht=3' (did "
                              "you mean 'Width=3'?)\n");
    bad("scene.pov Widht=3", "glim: error: unknown option 'Widht=3' (did you "
                             "mean 'Width=3'?)\n");
    bad("scene.pov --chekc", "glim: error: unknown option '--chekc' (did you "
                             "mean '--check'?)\n");
    bad("scene.pov +W", "glim: error: '+W': Width needs a value: type +W5\n");
    bad("scene.pov +W0", "glim: error: '+W0': Width must be from 1 to 65535\n");
    bad("scene.pov +W1e9",
        "glim: error: '+W1e9': Width must be from 1 to 65535\n");
    bad("scene.pov +W2x", "glim: error: '+W2x': Width wants a number, not "
                          "'2x'\n");
    bad("scene.pov Height=nan", "glim: error: 'Height=nan': Height wants a "
                                "number, not 'nan'\n");
    bad("scene.pov +FT +W60000 +H60000",
        "glim: error: 60000 x 60000 pixels are too many: glim's limit is "
        "268435456 in all, 16384 x 16384, but for PNG, PPM and OpenEXR files, "
        "which it draws in bands\n");
    bad("scene.pov --lighting ryas", "glim: error: '--lighting=ryas': there is "
                                     "no lighting 'ryas': type rays\n");
    bad("scene.pov Declare=5=6",
        "glim: error: 'Declare=5=6': Declare wants a name and a value, not "
        "'5=6': type Declare=Name=1\n");
    bad("scene.pov +FS",
        "glim: error: '+FS': there is no file type 'S': type +FN for PNG, "
        "+FE for OpenEXR, +FJ for JPEG; --list formats shows all\n");
    bad("-", "glim: error: a scene from standard input or a pipe has no name: "
             "type +Oname for the picture, or +O- for standard output\n");
    bad("none.pov", "glim: error: there is no scene 'none.pov', neither here "
                    "nor along the library path\n");
}

/* What is meant is found among the options' other names as well. */
static void errors_know_the_other_names(void **state)
{
    (void)state;
    bad("scene.pov +Wabc",
        "glim: error: unknown option '+Wabc' (+W wants a number; glim --help "
        "lists the options)\n");
    bad("scene.pov --width 10",
        "glim: error: unknown option '--width' (type +W10)\n");
    bad("scene.pov --width=10",
        "glim: error: unknown option '--width=10' (type +W10)\n");
    bad("scene.pov Seed=3", "glim: error: unknown option 'Seed=3' (did you "
                            "mean '--seed=3'?)\n");
    bad("scene.pov --mesh-shadow sharp",
        "glim: error: unknown option '--mesh-shadow' (did you mean "
        "'--mesh-shadows'?)\n");
    bad("scene.pov H10",
        "glim: error: 'H10' is no option like this: type +H10\n");
    bad("scene.pov Width 10",
        "glim: error: 'Width' is no option like this: type Width=n\n");
    bad("scene.pov part.ini[low",
        "glim: error: 'part.ini[low': a ']' is missing at its end\n");
}

static void ini_errors_point_into_the_file(void **state)
{
    (void)state;
    put("e.ini", "Width=20\nWidht = 3\n");
    bad("e.ini scene.pov", "e.ini:2:1: error: unknown option 'Widht'\n"
                           "    2 | Widht = 3\n"
                           "      | ^~~~~\n"
                           "      | Width\n");
    put("e.ini", "Width=20 Height=3\n");
    bad("e.ini scene.pov",
        "e.ini:1:7: error: Width wants a number, not '20 Height=3'; "
        "one Key=value on each line\n"
        "    1 | Width=20 Height=3\n"
        "      |       ^~~~~~~~~~~\n");
    put("e.ini", "Output_File_Name=\"a\n");
    bad("e.ini scene.pov", "e.ini:1:18: error: this quote is not closed\n"
                           "    1 | Output_File_Name=\"a\n"
                           "      |                  ^~\n");
    put("e.ini", "[a\n");
    bad("e.ini scene.pov",
        "e.ini:1:1: error: this '[' needs a ']' after the section's name\n"
        "    1 | [a\n"
        "      | ^~\n");
    put("e.ini", "e.ini\n");
    run("e.ini scene.pov");
    assert_int_equal(result.errors, 1);
    bad("e.ini[x] scene.pov", result.text);
}

static void arguments_after_two_dashes_are_scenes(void **state)
{
    (void)state;
    put("+W5", "");
    assert_string_equal(good("+H5 -- +W5")->input, "+W5");
    assert_string_equal(result.o.output, "+W5.png");
}

/* Whatever POV-Ray accepts is accepted: the command lines people have. */
static void povrays_options_are_accepted(void **state)
{
    (void)state;
    good("+Iscene +Oout.png +W320 +H240 +Q9 +A0.3 +AM2 +R3 -J -D -P +FN16 "
         "+WT2 -V +GS -GR +GDx -MB +MB25 +BM2 +SP8 +EP4 +BS16 +RP2 +RS3 "
         "+MV3.7 +MI128 +HR +RFfoo +RFI +RVP +UO +UF +UL +UV +UD -UR +SU +X "
         "+X5 +TH +THFS +D0TH +DG +GIx.ini +GP +WL5 +KC +K1 +HIscene.pov");
    good("scene.pov Antialias=on Antialias_Depth=3 Antialias_Gamma=2.5 "
         "Bounding=on Bounding_Method=1 Bounding_Threshold=3 "
         "Continue_Trace=off Create_Ini=x Display=off Display_Gamma=2.2 "
         "File_Gamma=sRGB Jitter=on Light_Buffer=on Pause_When_Done=off "
         "Preview_Start_Size=8 Quality=9 Remove_Bounds=on Split_Unions=off "
         "Test_Abort=on Test_Abort_Count=5 Verbose=off Version=3.7 "
         "Vista_Buffer=on Warning_Level=5 Work_Threads=2 All_Console=off");
}

static void the_table_is_sound(void **state)
{
    (void)state;
    for (size_t i = 0; option_at(i); i++) {
        const struct option *option = option_at(i);
        assert_non_null(option->help);
        if (!option->set)
            continue;
        assert_true(option->letters || option->key || option->word);
        if (option->letters)
            assert_ptr_equal(option_find_letters(option->letters), option);
        if (option->key)
            assert_ptr_equal(option_find_key(option->key), option);
        if (option->word)
            assert_ptr_equal(option_find_word(option->word), option);
        if (option->also)
            assert_non_null(option_find_key(option->also));
        if (option->fields)
            assert_non_null(field_find(option->fields, option->field));
    }
}

static void meshes_have_options_too(void **state)
{
    (void)state;
    put("glim.ini", "[Glim]\nMesh_Density=3\nMesh_Quality=7\n");
    struct options *o =
        good("scene.pov --mesh-quality 8 --mesh-shadows=sharp --mesh-levels 2 "
             "--mesh-indirect off --mesh-samples=50 --mesh-save a.mesh "
             "--mesh-only --skeleton-heuristic network");
    remove("glim.ini");
    struct settings scene = {
        .light_mesh = { .quality = 2, .radius = 4, .indirect = { .on = true } }
    };
    light_said_apply(&o->light_said, &o->light, &scene);
    assert_float_equal(scene.light_mesh.density, 3, 0);
    assert_float_equal(scene.light_mesh.quality, 8, 0);
    assert_float_equal(scene.light_mesh.radius, 4, 0); /* the scene's own */
    assert_int_equal(scene.light_mesh.shadows, MESH_SHADOWS_SHARP);
    assert_int_equal(scene.light_mesh.levels, 2);
    assert_false(scene.light_mesh.indirect.on);
    assert_int_equal(scene.light_mesh.indirect.samples, 50);
    assert_string_equal(scene.light_mesh.save_file, "a.mesh");
    assert_string_equal(scene.skeleton.heuristic, "network");
    assert_true(scene.light_mesh.only);
    assert_null(o->output);
    bad("scene.pov --mesh-quality 0",
        "glim: error: '--mesh-quality=0': Mesh_Quality must be from 1 to 10\n");
    bad("scene.pov --mesh-model=flat",
        "glim: error: '--mesh-model=flat': Mesh_Model is 'directional' or "
        "'scalar', not 'flat'\n");
    bad("scene.pov --mesh-indirect=maybe",
        "glim: error: '--mesh-indirect=maybe': Mesh_Indirect is on or off, "
        "not 'maybe'\n");
    bad("scene.pov --mesh-load",
        "glim: error: '--mesh-load': Mesh_Load needs a value: type "
        "--mesh-load file\n");
    bad("scene.pov --mesh-only",
        "glim: error: --mesh-only would keep nothing: add --mesh-save "
        "FILE\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(defaults_are_povrays),
        cmocka_unit_test(switches_take_either_sign_and_case),
        cmocka_unit_test(the_last_wins_but_not_of_declares),
        cmocka_unit_test(ini_files_have_sections_and_comments),
        cmocka_unit_test(ini_files_are_found_along_the_library),
        cmocka_unit_test(start_up_files_are_two_at_most),
        cmocka_unit_test(names_follow_povray),
        cmocka_unit_test(file_types_have_depth_and_grey),
        cmocka_unit_test(parts_count_from_one_or_are_shares),
        cmocka_unit_test(frames_are_povrays),
        cmocka_unit_test(errors_say_what_to_type),
        cmocka_unit_test(errors_know_the_other_names),
        cmocka_unit_test(ini_errors_point_into_the_file),
        cmocka_unit_test(arguments_after_two_dashes_are_scenes),
        cmocka_unit_test(povrays_options_are_accepted),
        cmocka_unit_test(meshes_have_options_too),
        cmocka_unit_test(the_table_is_sound),
    };
    int status = cmocka_run_group_tests_name("options", tests, setup, teardown);
    arena_free(result.arena);
    return status;
}
