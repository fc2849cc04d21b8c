/* text/ and token/: lines and columns, tokens, the printed message. */
#include "harness.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "text/diag.h"
#include "token/lexer.h"
#include "token/triangles.h"

struct fixture {
    struct arena *arena;
    struct word_table *words;
};

static int begin(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    fixture->arena = arena_new(0);
    fixture->words = word_table_new(fixture->arena);
    *state = fixture;
    return 0;
}

static int end(void **state)
{
    struct fixture *fixture = *state;
    arena_free(fixture->arena);
    free(fixture);
    return 0;
}

static const struct token_list *lex(struct fixture *fixture, const char *text)
{
    return lexer_run(fixture->arena, fixture->words,
                     source_from_text(fixture->arena, "test.pov", text));
}

static void expect_kinds(struct fixture *fixture, const char *text, int count,
                         const enum token_kind *kinds)
{
    const struct token_list *list = lex(fixture, text);
    assert_int_equal(list->count, count + 1);
    for (int i = 0; i < count; i++)
        assert_int_equal(list->tokens[i].kind, kinds[i]);
    assert_int_equal(list->tokens[count].kind, TOKEN_END);
}

static void words_end_at_numbers_points(void **state)
{
    enum token_kind kinds[] = { TOKEN_WORD, TOKEN_NUMBER, TOKEN_WORD,
                                TOKEN_NUMBER };
    expect_kinds(*state, "ambient.5diffuse 0", 4, kinds);
}

static void operators_of_two_characters(void **state)
{
    enum token_kind kinds[] = { TOKEN_LESS_EQUAL, TOKEN_GREATER_EQUAL,
                                TOKEN_NOT_EQUAL, TOKEN_NOT, TOKEN_LESS };
    expect_kinds(*state, "<= >= != ! <", 5, kinds);
}

static void comments_nest(void **state)
{
    enum token_kind kinds[] = { TOKEN_NUMBER, TOKEN_NUMBER };
    expect_kinds(*state, "1 /* a /* b */ c */ 2 // 3\r", 2, kinds);
}

static void bad_text_is_kept_for_later(void **state)
{
    enum token_kind kinds[] = { TOKEN_BAD, TOKEN_BAD, TOKEN_OTHER, TOKEN_BAD };
    expect_kinds(*state, "\xc2\xa3 1.2.3 $ \"open", 4, kinds);
}

static void numbers_are_exact(void **state)
{
    static const char *const texts[] = {
        "0.1",
        ".5",
        "1.",
        "3.14159265358979323846",
        "1e-3",
        "123456789.125",
        "0.000001",
        "1e308",
        "9007199254740993",
        "2.5E+2",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        const struct token_list *list = lex(*state, texts[i]);
        assert_int_equal(list->tokens[0].kind, TOKEN_NUMBER);
        assert_true(list->tokens[0].number == strtod(texts[i], NULL));
    }
}

/* vertex_vectors { 300, <0,-0.5,1e2>, <1,...> ... } */
static const char *long_list(struct fixture *fixture, const char *last)
{
    char *text = arena_printf(fixture->arena, "vertex_vectors { 300,");
    for (int i = 0; i < 299; i++)
        text = arena_printf(fixture->arena, "%s <%d,-0.5, 1e2>,", text, i);
    return arena_printf(fixture->arena, "%s %s } x", text, last);
}

static void long_plain_lists_are_one_token(void **state)
{
    const struct token_list *list = lex(*state, long_list(*state, "<7,8,9>"));
    assert_int_equal(list->count, 4);
    assert_int_equal(list->tokens[1].kind, TOKEN_NUMBERS);
    const struct number_list *numbers = list->tokens[1].numbers;
    assert_true(numbers->said == 300 && numbers->count == 300);
    assert_true(numbers->vectors[298][0] == 298);
    assert_true(numbers->vectors[298][1] == -0.5);
    assert_true(numbers->vectors[298][2] == 100);
    assert_true(numbers->vectors[299][2] == 9);
    assert_int_equal(list->tokens[2].kind, TOKEN_WORD);
}

static void other_lists_are_ordinary_tokens(void **state)
{
    static const char *const last[] = { "<7,8,9*2>", "<7,8 9>", "<7,8,1.2.3>",
                                        "<7,8", "" };
    for (size_t i = 0; i < sizeof last / sizeof *last; i++) {
        const struct token_list *list = lex(*state, long_list(*state, last[i]));
        assert_int_equal(list->tokens[1].kind,
                         *last[i] ? TOKEN_LBRACE : TOKEN_NUMBERS);
    }
}

static void plain_triangles_are_one_token(void **state)
{
    const struct token_list *list = lex(
        *state, "mesh { // leaves\n"
                "triangle { <0,-1.5,2>, <3 , 4,5> <6,7,8> texture { Leaf } }\n"
                "triangle{<0,0,0>,<1,0,0>,<0,1,0>}\n"
                "smooth_triangle { <1,2,3>, <4,5,6>, <7,8,9>, <10,11,12>, "
                "<13,14,15>, <16,17,18> } }");
    assert_int_equal(list->count, 6);
    assert_int_equal(list->tokens[2].kind, TOKEN_TRIANGLES);
    const struct triangle_run *run = list->tokens[2].triangles;
    assert_false(run->smooth);
    assert_int_equal(run->count, 2);
    assert_true(run->vectors[0][1] == -1.5 && run->vectors[1][0] == 3);
    assert_true(run->vectors[5][1] == 1);
    assert_string_equal(run->paints[0].texture->text, "Leaf");
    const char *text = list->source->text + list->tokens[2].offset;
    assert_memory_equal(text + run->paints[0].start, "texture { Leaf }", 16);
    assert_int_equal(run->paints[0].end - run->paints[0].start, 16);
    assert_null(run->paints[1].texture);
    run = list->tokens[3].triangles;
    assert_true(run->smooth && run->count == 1 && run->vectors[5][2] == 18);
}

/* Outside a mesh, and from the first that is not plain on. */
static void other_triangles_are_ordinary_tokens(void **state)
{
    static const char plain[] = "triangle { <0,0,0>, <1,0,0>, <0,1,0> }";
    static const char *const other[] = {
        "triangle { <0,0,0>*2, <1,0,0>, <0,1,0> }",
        "triangle { <0,0,x>, <1,0,0>, <0,1,0> }",
        "triangle { <0,0>, <1,0,0>, <0,1,0> }",
        "triangle { <0,0,0>, <1,0,0>, <0,1,0> texture { A[1] } }",
        "triangle { <0,0,0>, <1,0,0>, <0,1,0> texture { } }",
        "triangle { <0,0,0>, <1,0,0>, <0,1,0> texture { A } texture { A } }",
        "triangle { <0,0,0>, <1,0,0>",
        "triangles { <0,0,0>, <1,0,0>, <0,1,0> }",
    };
    struct fixture *fixture = *state;
    const struct token_list *list = lex(*state, plain);
    assert_int_equal(list->tokens[0].kind, TOKEN_WORD);
    for (size_t i = 0; i < sizeof other / sizeof *other; i++) {
        list = lex(*state, arena_printf(fixture->arena, "mesh { %s %s }", plain,
                                        other[i]));
        assert_int_equal(list->tokens[2].kind, TOKEN_TRIANGLES);
        assert_int_equal(list->tokens[2].triangles->count, 1);
        assert_int_equal(list->tokens[3].kind, TOKEN_WORD);
        assert_int_equal(list->tokens[4].kind, TOKEN_LBRACE);
    }
}

static void strings_resolve_escapes(void **state)
{
    const struct token_list *list =
        lex(*state, "\"a\\tb\\\\c\\\"d\\u00e9 C:\\Kept\"");
    assert_int_equal(list->tokens[0].kind, TOKEN_STRING);
    assert_string_equal(list->tokens[0].text, "a\tb\\c\"d\xc3\xa9 C:\\Kept");
}

static void spellings_share_keywords(void **state)
{
    const struct token_list *list = lex(*state, "color colour Color #declare");
    assert_int_equal(list->tokens[0].word->keyword, KEYWORD_COLOUR);
    assert_int_equal(list->tokens[1].word->keyword, KEYWORD_COLOUR);
    assert_int_equal(list->tokens[2].word->keyword, KEYWORD_NONE);
    assert_int_equal(list->tokens[3].kind, TOKEN_DIRECTIVE);
    assert_int_equal(list->tokens[3].word->keyword, KEYWORD_DECLARE);
}

static void lines_end_in_all_ways(void **state)
{
    struct fixture *fixture = *state;
    const struct source *source =
        source_from_text(fixture->arena, "x", "a\nb\r\nc\rd");
    struct source_place place = source_locate(source, 7);
    assert_int_equal(place.line, 4);
    assert_int_equal(place.column, 1);
    place = source_locate(source, 5);
    assert_int_equal(place.line, 3);
}

static void expect_message(struct fixture *fixture, const char *text,
                           uint32_t offset, uint32_t length, const char *hint,
                           const char *expected)
{
    char printed[1024] = { 0 };
    struct diag diag = diag_new();
    diag.out = fmemopen(printed, sizeof printed - 1, "w");
    struct span span = { source_from_text(fixture->arena, "a.pov", text),
                         offset, length };
    diag_print(&diag, DIAG_ERROR, span, hint, "what");
    fclose(diag.out);
    assert_string_equal(printed, expected);
}

static void messages_point(void **state)
{
    expect_message(*state, "sphere {\n\tpigmnt\n}", 10, 6, "pigment",
                   "a.pov:2:2: error: what\n"
                   "    2 |         pigmnt\n"
                   "      |         ^~~~~~\n"
                   "      |         pigment\n");
    expect_message(*state, "\xc3\xa9 x", 3, 1, NULL,
                   "a.pov:1:4: error: what\n"
                   "    1 | \xc3\xa9 x\n"
                   "      |   ^\n");
    expect_message(*state, "x", 1, 0, NULL,
                   "a.pov:1:2: error: what\n"
                   "    1 | x\n"
                   "      |  ^\n");
}

static void errors_beyond_the_limit_are_silent(void **state)
{
    (void)state;
    char printed[8192] = { 0 };
    struct diag diag = diag_new();
    diag.out = fmemopen(printed, sizeof printed - 1, "w");
    for (int i = 0; i < DIAG_ERROR_LIMIT + 5; i++)
        diag_print(&diag, DIAG_ERROR, span_none(), NULL, "no");
    fclose(diag.out);
    int lines = 0;
    for (const char *p = printed; *p; p++)
        lines += *p == '\n';
    assert_int_equal(lines, DIAG_ERROR_LIMIT);
    assert_int_equal(diag.errors, DIAG_ERROR_LIMIT + 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(words_end_at_numbers_points),
        cmocka_unit_test(operators_of_two_characters),
        cmocka_unit_test(comments_nest),
        cmocka_unit_test(bad_text_is_kept_for_later),
        cmocka_unit_test(numbers_are_exact),
        cmocka_unit_test(long_plain_lists_are_one_token),
        cmocka_unit_test(other_lists_are_ordinary_tokens),
        cmocka_unit_test(plain_triangles_are_one_token),
        cmocka_unit_test(other_triangles_are_ordinary_tokens),
        cmocka_unit_test(strings_resolve_escapes),
        cmocka_unit_test(spellings_share_keywords),
        cmocka_unit_test(lines_end_in_all_ways),
        cmocka_unit_test(messages_point),
        cmocka_unit_test(errors_beyond_the_limit_are_silent),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
