/* The table of options: one row is the switch, the INI key, the long word, the
 * range, and the text of --help and of man/glim.1. See option.h. */
#include "cli/option.h"

#include <string.h>

#include "base/text.h"

#define AT(field)   offsetof(struct options, field)
#define NAMES(l, k) .letters = l, .key = k
#define GROUP(title)                                                           \
    {                                                                          \
        .help = title                                                          \
    }
/* What a value of each kind is called is in `argument`. */
#define INTEGER(l, k, field, low, high, text)                                  \
    {                                                                          \
        NAMES(l, k), .set = set_integer, .offset = AT(field), .minimum = low,  \
                     .maximum = high, .argument = "n", .help = text            \
    }
#define WHOLE(l, k, field, low, high, text)                                    \
    {                                                                          \
        NAMES(l, k), .set = set_whole, .offset = AT(field), .minimum = low,    \
                     .maximum = high, .argument = "n", .help = text            \
    }
#define NUMBER(l, k, field, low, high, text)                                   \
    {                                                                          \
        NAMES(l, k), .set = set_number, .offset = AT(field), .minimum = low,   \
                     .maximum = high, .argument = "n", .help = text            \
    }
#define SWITCH(l, k, field, text)                                              \
    {                                                                          \
        NAMES(l, k), .set = set_switch, .offset = AT(field),                   \
                     .argument = "bool", .help = text                          \
    }
/* A switch whose value, if it has one, is that of another key. */
#define SWITCH_AND(l, k, field, other, value, text)                            \
    {                                                                          \
        NAMES(l, k), .set = set_switch, .offset = AT(field), .also = other,    \
                     .argument = value, .help = text                           \
    }
#define VALUE(l, k, setter, value, text)                                       \
    {                                                                          \
        NAMES(l, k), .set = setter, .argument = value, .help = text            \
    }
#define WORD(w, setter, number, value, text)                                   \
    {                                                                          \
        .word = w, .set = setter, .offset = number, .argument = value,         \
        .help = text                                                           \
    }
#define LIGHT_OF(lightings, k, w, table, name, value, text)                    \
    {                                                                          \
        .key = k, .word = w, .set = set_light, .of = lightings,                \
        .fields = table, .field = name, .argument = value, .help = text        \
    }
#define LIGHT(k, w, table, name, value, text)                                  \
    LIGHT_OF("mesh", k, w, table, name, value, text)
#define MESHES(k, w, table, name, value, text)                                 \
    LIGHT_OF("mesh paper", k, w, table, name, value, text)
#define VOID(k, w, table, name, value, text)                                   \
    LIGHT_OF("skeleton mesh path", k, w, table, name, value, text)
#define NOTHING_OF(l, k, value)                                                \
    {                                                                          \
        NAMES(l, k), .set = set_ignored, .offset = value, .argument = "",      \
                     .help = ""                                                \
    }
#define NOTHING(l, k) NOTHING_OF(l, k, IGNORED_SWITCH)
#define CONSOLE(l, k, setter, field, file, text)                               \
    {                                                                          \
        NAMES(l, k), .set = setter, .offset = field, .also = file,             \
                     .argument = "bool", .help = text                          \
    }

enum { FRAME_LIMIT = 1000000000 };

/* clang-format off */
static const struct option table[] = {
    GROUP("Files"),
    VALUE("I", "Input_File_Name", set_input, "file",
          "the scene; .pov may be left out; - is standard input"),
    VALUE("O", "Output_File_Name", set_output, "file",
          "the picture (the scene's name with the type's extension); dir/ "
          "puts it there; - is standard output"),
    SWITCH_AND("F", "Output_to_File", to_file, "Output_File_Type", "[type]",
               "write a picture (on); for the types see --list formats; a "
               "number gives the bits, g makes it grey: +FN16g"),
    VALUE(NULL, "Output_File_Type", set_file_type, "type", "as in +F (N)"),
    INTEGER(NULL, "Bits_Per_Color", bits, 1, 32,
            "of PNG and PPM files, up to 16 (8; grey PNG 16); 32 makes OpenEXR "
            "files of floats, not halves"),
    SWITCH(NULL, "Grayscale_Output", grey,
           "one channel, 0.297 red + 0.589 green + 0.114 blue (off)"),
    INTEGER(NULL, "Compression", compression, 0, 100,
            "quality of JPEG files, 2 to 100; less is as if not said (85)"),
    SWITCH("UA", "Output_Alpha", alpha,
           "write opacity to PNG, Targa, BMP and OpenEXR (off); in scenes of a "
           "#version before 3.7, or of none, sky and background are then left "
           "out"),
    SWITCH("C", "Continue_Trace", continue_trace,
           "keep pictures that are whole and current (off)"),
    WORD("part", set_text, AT(part), "i/n",
         "draw the i-th of n parts of the picture, into NAME.iofn.glim-part; "
         "array: as the array job says that this is a task of; strip: what +SR "
         "+ER +SC +EC choose"),
    WORD("join", set_join, AT(picture), "[file]",
         "make the picture of that name, or of the scene that is named, of all "
         "its parts"),
    WORD("check-picture", set_check_picture, AT(picture), "file",
         "say what a picture is of, and whether it is whole and current"),
    { .letters = "MF", .word = "depend", .set = set_text,
      .offset = AT(depend.file), .argument = "file",
      .help = "write a rule for make there: the picture, and every file that "
              "was read or looked for" },
    { .letters = "MT", .word = "depend-target", .set = set_text,
      .offset = AT(depend.target), .argument = "target",
      .help = "its target, as it is to stand there (the picture)" },
    { .letters = "MD", .set = set_flag, .offset = AT(depend.on),
      .help = "the same beside the picture, its name with .d, unless -MF names "
              "another" },
    { .letters = "MP", .set = set_flag, .offset = AT(depend.phony),
      .help = "a rule for each of these files, too, so that one may be "
              "removed" },
    VALUE("L", "Library_Path", set_library, "dir",
          "search for includes, images and INI files here too; adds up"),
    VALUE("HI", "Include_Header", set_header, "file",
          "read this file before the scene; adds up"),
    { .key = "Read_Only_Below", .word = "read-only-below", .set = set_below,
      .argument = "dir",
      .help = "the scene may read what is in this directory, or in that of the "
              "scene or of the library path, and deeper in them, and nothing "
              "else; adds up" },

    GROUP("Picture"),
    INTEGER("W", "Width", render.width, 1, IMAGE_SIDE_LIMIT, "pixels (800)"),
    INTEGER("H", "Height", render.height, 1, IMAGE_SIDE_LIMIT,
            "pixels (600)"),
    NUMBER("SC", "Start_Column", columns[0], 0, IMAGE_SIDE_LIMIT,
           "leave out what is left of column n, counted from 1; below 1 a "
           "share of the width"),
    NUMBER("EC", "End_Column", columns[1], 0, IMAGE_SIDE_LIMIT,
           "leave out what is right of column n; up to 1 a share of the "
           "width"),
    NUMBER("SR", "Start_Row", rows[0], 0, IMAGE_SIDE_LIMIT,
           "leave out what is above row n, as +SC"),
    NUMBER("ER", "End_Row", rows[1], 0, IMAGE_SIDE_LIMIT,
           "leave out what is below row n, as +EC"),
    { .key = "File_Gamma", .set = set_gamma, .offset = AT(file_gamma),
      .argument = "gamma",
      .help = "of files that are not linear: a number or sRGB (sRGB)" },

    GROUP("Quality"),
    SWITCH_AND("A", "Antialias", render.antialias, "Antialias_Threshold",
               "[n]", "smooth where colours differ by n or more (off)"),
    NUMBER(NULL, "Antialias_Threshold", render.threshold, 0, 1000,
           "as in +An (0.3)"),
    INTEGER("AM", "Sampling_Method", render.method, 1, 2,
            "1: a grid of samples, 2: recursive (1)"),
    INTEGER("R", "Antialias_Depth", render.depth, 1, 9,
            "n x n samples, or n levels with +AM2 (3)"),
    SWITCH_AND("J", "Jitter", jitter, "Jitter_Amount", "[n]",
               "shift the samples a little (on)"),
    NUMBER(NULL, "Jitter_Amount", render.jitter, 0, 10,
           "how far, in samples (1)"),
    NUMBER("AG", "Antialias_Gamma", render.antialias_gamma, 0.01, 100,
           "of colours when they are compared (2.5)"),
    INTEGER("Q", "Quality", quality, 0, 11,
            "0: plain colours, 4: shadows, 5: area lights, 6: textures, 8: "
            "bumps, reflection and refraction, 9: all (9)"),
    { .key = "Lighting", .word = "lighting", .set = set_lighting,
      .argument = "name",
      .help = "how light is worked out (mesh); see --list lightings" },
    WORD("show", set_text, AT(show), "name",
         "draw what the lighting knows over the picture: skeleton, "
         "skeleton:irradiance, stream, mesh, mesh:indirect, knower"),
    WORD("debug-pixel", set_text, AT(debug_pixel), "x,y",
         "instead of a picture tell what made this pixel, counted from 1: "
         "surfaces, lamps, who knew their light, and its cost"),
    { .key = "Samples", .word = "samples", .of = "path", .set = set_integer,
      .offset = AT(samples), .minimum = 1, .maximum = OPTIONS_SAMPLE_LIMIT,
      .argument = "n",
      .help = "with --lighting path: of each pixel, +A or not (64; with a "
              "target as many as it takes, up to 65536)" },
    { .key = "Target_Error", .word = "target-error", .of = "path", .set = set_number,
      .offset = AT(render.target_error), .minimum = 0, .maximum = 1,
      .argument = "n",
      .help = "with --lighting path: enough when the estimated relative "
              "error is n (0: never)" },
    { .key = "Target_Time", .word = "target-time", .of = "path", .set = set_number,
      .offset = AT(render.target_time), .minimum = 0, .maximum = 1e9,
      .argument = "seconds",
      .help = "with --lighting path: enough after that time (0: never)" },
    { .key = "Stochastic_Seed", .word = "seed", .set = set_integer,
      .offset = AT(render.seed), .minimum = 0, .maximum = 2147483647,
      .argument = "n",
      .help = "with --lighting path: another number, another noise (0)" },

    GROUP("Light mesh and skeleton; they win over the scene's own"),
    MESHES("Mesh_Quality", "mesh-quality", light_mesh_fields, "quality", "n",
          "1 to 10, the knob to turn first (5)"),
    MESHES("Mesh_Density", "mesh-density", light_mesh_fields, "density", "n",
          "mesh points for one unit of length"),
    MESHES("Mesh_Radius", "mesh-radius", light_mesh_fields, "radius", "n",
          "how far a mesh point is heard, in units"),
    MESHES("Mesh_Interpolation", "mesh-interpolation", light_mesh_fields,
          "interpolation", "name",
          "between mesh points; see --list interpolations"),
    LIGHT("Mesh_Model", "mesh-model", light_mesh_fields, "model", "name",
          "directional, or scalar as in the paper (directional)"),
    LIGHT("Mesh_Shadows", "mesh-shadows", light_mesh_fields, "shadows",
          "name", "soft, sharp, or what is quick and right (auto)"),
    MESHES("Mesh_Threshold", "mesh-threshold", light_mesh_fields, "threshold",
          "n", "new points where neighbours differ by more (0.2)"),
    MESHES("Mesh_Levels", "mesh-levels", light_mesh_fields, "levels", "n",
          "how often the distance of points is halved for that (2)"),
    LIGHT("Mesh_Sky", "mesh-sky", light_mesh_fields, "sky", "bool",
          "sky and background light the scene, in place of ambient (off)"),
    MESHES("Mesh_Indirect", "mesh-indirect", light_option_fields, "indirect",
          "bool", "light from surface to surface (on)"),
    MESHES("Mesh_Samples", "mesh-samples", indirect_fields, "samples", "n",
          "rays that gather it at a mesh point"),
    LIGHT("Mesh_Bounces", "mesh-bounces", indirect_fields, "bounces", "n",
          "from surface to surface"),
    LIGHT("Mesh_Skeleton", "mesh-skeleton", indirect_fields, "skeleton",
          "bool", "the skeleton's light ends the last of them (on)"),
    LIGHT_OF(NULL, "Mesh_Save", "mesh-save", light_option_fields, "save", "file",
          "write the mesh here when the picture is done"),
    MESHES("Mesh_Load", "mesh-load", light_option_fields, "load", "file",
          "begin with this mesh"),
    LIGHT_OF(NULL, NULL, "mesh-only", light_option_fields, "only", NULL,
          "make the mesh for --mesh-save and write no picture"),
    VOID("Skeleton_Resolution", "skeleton-resolution", skeleton_fields,
          "resolution", "n", "voxels along the scene's longest side (128)"),
    VOID("Skeleton_Heuristic", "skeleton-heuristic", skeleton_fields,
         "heuristic", "name",
         "how light is estimated along the skeleton; see --list heuristics"),
    LIGHT_OF(NULL, "Skeleton_Save", "skeleton-save", light_option_fields,
          "skeleton_save", "file",
          "write the skeleton and its light here: .ply, .obj or .csv"),
    LIGHT_OF("path", "Guide", "guide", light_option_fields, "guide", "name",
          "with --lighting path: skeleton, where to look for light (off)"),

    GROUP("Scene"),
    VALUE(NULL, "Declare", set_declare, "name=value",
          "as #declare before the scene; the first of a name counts"),
    NUMBER("MV", "Version", parse.version, 1, 100,
           "the language's version at the scene's start"),
    NUMBER("K", "Clock", clock, -1e300, 1e300,
           "clock of a single picture (0)"),

    GROUP("Animation"),
    WHOLE("KFF", "Final_Frame", frames.final, 0, FRAME_LIMIT,
          "render frames up to n"),
    WHOLE("KFI", "Initial_Frame", frames.initial, 0, FRAME_LIMIT,
          "number of the first frame (1)"),
    NUMBER("KI", "Initial_Clock", frames.initial_clock, -1e300, 1e300,
           "clock of the first frame (0)"),
    NUMBER("KF", "Final_Clock", frames.final_clock, -1e300, 1e300,
           "clock of the last frame (1)"),
    SWITCH("KC", "Cyclic_Animation", frames.cyclic,
           "the frame after the last would be the first again (off)"),
    NUMBER("SF", "Subset_Start_Frame", frames.subset_start, 0, FRAME_LIMIT,
           "leave out the frames before n; below 1 a share of all"),
    NUMBER("EF", "Subset_End_Frame", frames.subset_end, 0, FRAME_LIMIT,
           "leave out the frames after n"),
    { NAMES("STP", "Frame_Step"), .set = set_step, .offset = AT(frames.step),
      .minimum = -FRAME_LIMIT, .maximum = FRAME_LIMIT, .argument = "n",
      .help = "every n-th frame (1); below 0 from the end backwards" },
    WORD("frames", set_text, AT(frames_said), "i/n",
         "of the frames to render the i-th of n rows; array: as the array job "
         "says"),

    GROUP("Work"),
    { NAMES("WT", "Work_Threads"), .word = "threads", .set = set_integer,
      .offset = AT(threads), .minimum = 1, .maximum = OPTIONS_THREAD_LIMIT,
      .argument = "n", .help = "threads (one for each core)" },
    INTEGER("BS", "Render_Block_Size", render.tile, 4, 4096,
            "side of the squares that threads work on, in pixels (32)"),

    GROUP("Messages"),
    VALUE("V", "Verbose", set_verbose, "bool",
          "tell progress even where standard error is no terminal; -V never"),
    INTEGER("WL", "Warning_Level", warning_level, 0, 10,
            "0: no warnings (10)"),
    CONSOLE("GD", "Debug_Console", set_switch, AT(messages), "Debug_File",
            "show what #debug says (on)"),
    CONSOLE("GW", "Warning_Console", set_switch, AT(warnings),
            "Warning_File", "show warnings (on)"),
    CONSOLE("GA", "All_Console", set_all_consoles, 0, "All_File",
            "both; errors are always shown"),
    WORD("quiet", set_quiet, 0, NULL, "nothing but errors: as -V -GA"),
    WORD("progress", set_progress, AT(progress_form), "[json]",
         "tell progress everywhere; json: a line of JSON a second"),
    WORD("stats", set_stats, AT(stats_form), "[json]",
         "objects, rays and times, and what light meshes took; json: as one "
         "line of JSON"),

    GROUP("Other things to do"),
    WORD("watch", set_flag, AT(watch), NULL,
         "render again whenever the scene or a file it uses changes"),
    WORD("check", set_action, ACTION_CHECK, NULL,
         "read the scene and report what is wrong; render nothing"),
    WORD("probe", set_text, AT(probe), "file",
         "print the irradiance at points instead of drawing: lines x y z nx "
         "ny nz, or x y z; - is standard input"),
    WORD("list", set_list, 0, "[what]",
         "primitives, patterns, cameras, keywords, lightings, interpolations, "
         "heuristics, formats or options"),
    WORD("language-server", set_action, ACTION_LANGUAGE_SERVER, NULL,
         "help in an editor: the Language Server Protocol on standard input "
         "and output"),
    WORD("help", set_action, ACTION_HELP, NULL, "this list"),
    WORD("version", set_action, ACTION_VERSION, NULL,
         "the version and the build"),
    WORD("man-options", set_action, ACTION_MAN, NULL,
         "this list for the manual page"),

    GROUP("Accepted for POV-Ray's sake"),
    CONSOLE("D", "Display", set_ignored, IGNORED_TEXT, "Video_Mode",
            "there is no preview window"),
    NOTHING(NULL, "Video_Mode"),
    NOTHING(NULL, "Palette"),
    NOTHING(NULL, "Display_Gamma"),
    NOTHING("P", "Pause_When_Done"),
    NOTHING_OF("SP", "Preview_Start_Size", IGNORED_NUMBER),
    NOTHING_OF("EP", "Preview_End_Size", IGNORED_NUMBER),
    NOTHING_OF("RP", "Render_Pattern", IGNORED_NUMBER),
    NOTHING_OF("RS", "Render_Block_Step", IGNORED_NUMBER),
    NOTHING_OF("X", "Test_Abort", IGNORED_NUMBER),
    NOTHING(NULL, "Test_Abort_Count"),
    NOTHING("HR", "High_Reproducibility"),
    NOTHING(NULL, "Antialias_Confidence"),
    NOTHING_OF("TH", "Dither", IGNORED_TEXT),
    NOTHING(NULL, "Dither_Method"),
    NOTHING_OF("MB", "Bounding", IGNORED_NUMBER),
    NOTHING(NULL, "Bounding_Threshold"),
    NOTHING_OF("BM", "Bounding_Method", IGNORED_NUMBER),
    NOTHING(NULL, "BSP_MaxDepth"),
    NOTHING(NULL, "BSP_BaseAccessCost"),
    NOTHING(NULL, "BSP_ChildAccessCost"),
    NOTHING(NULL, "BSP_IsectCost"),
    NOTHING(NULL, "BSP_MissChance"),
    NOTHING("UR", "Remove_Bounds"),
    NOTHING("SU", "Split_Unions"),
    NOTHING("UL", "Light_Buffer"),
    NOTHING("UV", "Vista_Buffer"),
    NOTHING("UD", "Draw_Vistas"),
    NOTHING("KLA", "Clockless_Animation"),
    NOTHING("RTR", "Real_Time_Raytracing"),
    NOTHING_OF("B", "Buffer_Output", IGNORED_NUMBER),
    NOTHING(NULL, "Buffer_Size"),
    NOTHING(NULL, "Histogram_Type"),
    NOTHING(NULL, "Histogram_Name"),
    NOTHING(NULL, "Histogram_Grid_Size"),
    NOTHING("UF", "Field_Render"),
    NOTHING("UO", "Odd_Field"),
    NOTHING_OF("MI", "Max_Image_Buffer_Memory", IGNORED_NUMBER),
    NOTHING_OF("RF", "Radiosity_File_Name", IGNORED_TEXT),
    NOTHING_OF("RFI", "Radiosity_From_File", IGNORED_TEXT),
    NOTHING_OF("RFO", "Radiosity_To_File", IGNORED_TEXT),
    NOTHING("RVP", "Radiosity_Vain_Pretrace"),
    NOTHING_OF("GI", "Create_Ini", IGNORED_TEXT),
    CONSOLE("GR", "Render_Console", set_ignored, IGNORED_TEXT, "Render_File",
            ""),
    CONSOLE("GS", "Statistic_Console", set_ignored, IGNORED_TEXT,
            "Statistic_File", "see --stats"),
    CONSOLE("GF", "Fatal_Console", set_ignored, IGNORED_TEXT, "Fatal_File",
            "errors are always shown"),
    NOTHING("GP", "Append_File"),
    VALUE(NULL, "All_File", set_message_file, "file", ""),
    VALUE(NULL, "Debug_File", set_message_file, "file", ""),
    VALUE(NULL, "Fatal_File", set_message_file, "file", ""),
    VALUE(NULL, "Render_File", set_message_file, "file", ""),
    VALUE(NULL, "Statistic_File", set_message_file, "file", ""),
    VALUE(NULL, "Warning_File", set_message_file, "file", ""),
    VALUE(NULL, "Pre_Scene_Command", set_no_command, "command", ""),
    VALUE(NULL, "Post_Scene_Command", set_no_command, "command", ""),
    VALUE(NULL, "Pre_Frame_Command", set_no_command, "command", ""),
    VALUE(NULL, "Post_Frame_Command", set_no_command, "command", ""),
    VALUE(NULL, "User_Abort_Command", set_no_command, "command", ""),
    VALUE(NULL, "Fatal_Error_Command", set_no_command, "command", ""),
    NOTHING(NULL, "Pre_Scene_Return"),
    NOTHING(NULL, "Post_Scene_Return"),
    NOTHING(NULL, "Pre_Frame_Return"),
    NOTHING(NULL, "Post_Frame_Return"),
    NOTHING(NULL, "User_Abort_Return"),
    NOTHING(NULL, "Fatal_Error_Return"),
};
/* clang-format on */

const struct option *option_at(size_t index)
{
    return index < sizeof table / sizeof *table ? &table[index] : NULL;
}

const struct option *option_find_key(const char *key)
{
    for (size_t i = 0; option_at(i); i++)
        if (table[i].key && text_equal_nocase(table[i].key, key))
            return &table[i];
    return NULL;
}

const struct option *option_find_word(const char *word)
{
    for (size_t i = 0; option_at(i); i++)
        if (table[i].word && strcmp(table[i].word, word) == 0)
            return &table[i];
    return NULL;
}

static bool option_begins(const char *text, const char *letters)
{
    for (; *letters; text++, letters++)
        if ((*text | 32) != (*letters | 32)) /* letters are A to Z */
            return false;
    return true;
}

const struct option *option_find_letters(const char *text)
{
    const struct option *best = NULL;
    for (size_t i = 0; option_at(i); i++) {
        const char *letters = table[i].letters;
        if (letters && option_begins(text, letters) &&
            (!best || strlen(letters) > strlen(best->letters)))
            best = &table[i];
    }
    return best;
}

const char *option_spelling(const struct option *option, bool word,
                            struct arena *arena)
{
    const char *name = word ? option->word : option->key;
    return arena_printf(arena, "%s%s%s%s", word ? "--" : "", name,
                        !option->argument ? ""
                        : word            ? " "
                                          : "=",
                        option->argument ? option->argument : "");
}
