/* Arrays, user functions, random numbers, identifiers; and the first line of
 * what is printed for mistakes in expressions. */
#include "harness.h"

#include "scene_text.h"

struct check {
    const char *declarations, *expression, *value;
};

static void check_all(const struct check *checks, size_t count)
{
    unsigned wrong = 0;
    for (size_t i = 0; i < count; i++) {
        char *found =
            scene_text_marked(checks[i].declarations, checks[i].expression);
        if (!found || strcmp(found, checks[i].value) != 0) {
            print_error("%s: expected %s, found %s\n", checks[i].declarations,
                        checks[i].value, found ? found : "an error");
            wrong++;
        }
        free(found);
    }
    assert_int_equal(wrong, 0);
}

#define CHECK(table) check_all(table, sizeof table / sizeof *table)

static void test_arrays(void **state)
{
    static const struct check checks[] = {
        { "#declare A = array[3] {1,2,3}", "str(A[0]+A[1.9],0,0)", "3" },
        { "#declare A = array[2] {1 2,}", "str(A[2.99999999-1],0,0)", "2" },
        { "#declare A = array[31]; #declare A[3] = 7;", "str(A[0.1*30],0,0)",
          "7" },
        { "#declare A = array[3]; #declare A[0] = x;", "str(A[0].x,0,0)", "1" },
        { "#declare A = array[2][2] {{1,2},{3,4}}", "str(A[1][0],0,0)", "3" },
        { "#declare A = array[2][3];",
          "str(dimensions(A)*100+dimension_size(A,1)*10+dimension_size(A,2),"
          "0,0)",
          "223" },
        { "#declare A = array[1];", "str(dimension_size(A,2),0,0)", "0" },
        { "#declare A = array[2] {1,2} #declare B = A; #declare B[0] = 9;",
          "str(A[0]*10+B[0],0,0)", "19" },
        { "#declare A = array[2] {1,2} #declare B = array[2] {A,A}"
          "#declare B[0][1] = 5;",
          "str(A[1]*100+B[0][1]*10+B[1][1],0,0)", "252" },
        { "#declare A = array[2] {\"a\",\"b\"}", "A[1]", "b" },
        { "#declare A = array[2] {rgb 1, rgb x}", "str(A[1].red,0,0)", "1" },
        { "#declare A = array[1] {sphere{0,1}}", "str(min_extent(A[0]).x,0,0)",
          "-1" },
    };
    (void)state;
    CHECK(checks);
}

static void test_user_functions(void **state)
{
    static const struct check checks[] = {
        { "#declare f = function {x+2*y}", "str(f(1,2,3),0,0)", "5" },
        { "#declare f = function {u*10+v}", "str(f(1,2,3),0,0)", "12" },
        { "#declare f = function(a,b) {a-b}", "str(2*f(5,3)+1,0,0)", "5" },
        { "#declare f = function(a) {-a*a}", "str(f(3),0,0)", "-9" },
        { "#declare f = function(a) {(a<2)+(a>0)}", "str(f(1),0,0)", "2" },
        { "#declare f = function(a) {a<=2 & a>=1}", "str(f(2),0,0)", "1" },
        { "#declare f = function(a) {1 | 0 & a}", "str(f(0),0,0)", "1" },
        { "#declare f = function(a) {select(a,1,2,3)}",
          "str(f(-1)*100+f(0)*10+f(1),0,0)", "123" },
        { "#declare f = function(a) {select(a,1,2)}",
          "str(f(-1)*100+f(0)*10+f(1),0,0)", "122" },
        { "#declare f = function(a) {sum(i,1,a,i*2)}",
          "str(f(3)*100+f(0)*10+f(2.5),0,0)", "1206" },
        { "#declare f = function(a) {prod(i,1,a,i)}", "str(f(4)+f(0),0,0)",
          "25" },
        { "#declare f = function(a) {sum(i,1,a,sum(j,1,i,j))}", "str(f(3),0,0)",
          "10" },
        { "#declare f = function(a) {min(a,1,2)+max(a,3)}", "str(f(0),0,0)",
          "3" },
        { "#declare A=3; #declare f = function(a) {a+A} #declare A=10;",
          "str(f(1),0,0)", "4" },
        { "#declare g = function(a) {a*2} #declare f = function(a) {g(a)+g(1)}",
          "str(f(3),0,0)", "8" },
        { "#declare A = array[2] {5,6} #declare f = function(a) {a+A[1]}",
          "str(f(1),0,0)", "7" },
        { "#declare f = function(a) { 0 #local i=0; #while(i<3) + a*i "
          "#local i=i+1; #end }",
          "str(f(2),0,0)", "6" },
        { "#declare f = function(a) {sqrt(a)}", "str(f(4),0,0)", "2" },
        { "#include \"functions.inc\"", "str(1,0,0)", "1" },
        { "#include \"math.inc\"", "str(even(4)+clamp(5,0,3),0,0)", "3" },
    };
    (void)state;
    CHECK(checks);
}

static void test_random(void **state)
{
    static const struct check checks[] = {
        { "#declare S = seed(1);", "str(rand(S),0,10)", "0.4219928753" },
        { "#declare S = seed(1); #declare R = rand(S);", "str(rand(S),0,10)",
          "0.4871211982" },
        { "#declare S = seed(1); #declare T = seed(-5);", "str(rand(T),0,10)",
          "0.8900528701" },
        { "#declare S = seed(5e9);", "str(rand(S),0,10)", "0.5000028744" },
        { "#declare S = seed(1); #declare T = seed(1);", "str(T*10+S,0,0)",
          "10" },
    };
    (void)state;
    CHECK(checks);
}

/* The values are POV-Ray's. */
static void test_probes(void **state)
{
    static const struct check checks[] = {
        { "#declare S = sphere {0,1} #declare N = x;"
          "#declare P = trace(S, <0.5,0,-3>, z, N);",
          "concat(vstr(3,P,\" \",0,3), \" \", vstr(3,N,\" \",0,3))",
          "0.500 0.000 -0.866 0.500 0.000 -0.866" },
        { "#declare S = sphere {0,1} #declare N = x;"
          "#declare P = trace(S, <3,0,-3>, z, N);",
          "vstr(3,P+N,\" \",0,0)", "0 0 0" },
        { "#declare S = sphere {0,1}",
          "str(trace(S,<0,0,-1-5e-4>,z).z*10+trace(S,<0,0,-1-5e-5>,3*z).z,"
          "0,0)",
          "-9" },
        { "#declare U = union {sphere {0,1} sphere {x*.5,1}} ",
          "str(trace(U,0,x).x,0,1)", "1.0" },
        { "#declare U = union {sphere {0,1} sphere {x*.5,1} inverse}"
          "#declare N = x; #declare P = trace(U,0,x,N);",
          "str(P.x*10+N.x,0,0)", "14" },
        { "#declare D = difference {box {-1,1} sphere {0,1.2}}",
          "str(trace(D,<.9,.9,-3>,z).z,0,1)", "-1.0" },
        { "#declare T = triangle {<-1,-1,0>,<1,-1,0>,<0,1,0>}"
          "#declare N = x; #declare P = trace(T,-3*z,z,N);",
          "str(N.z,0,0)", "-1" },
        { "#declare D = difference {box {-1,1} sphere {0,1.2}}",
          "str(inside(D,<.9,.9,.9>)*10+inside(D,0),0,0)", "10" },
        { "#declare C = sphere {0,1 clipped_by {plane {z,0}}}",
          "str(inside(C,-.5*z)*10+inside(C,.5*z),0,0)", "10" },
        { "#declare S = sphere {0,1 inverse}",
          "str(inside(S,0)*10+inside(S,2*x),0,0)", "1" },
        { "",
          "str(bitwise_and(7,5,4)*100+bitwise_or(5,3)*10+"
          "bitwise_xor(5,3),0,0)",
          "476" },
    };
    (void)state;
    CHECK(checks);
}

static void test_identifiers(void **state)
{
    static const struct check checks[] = {
        { "#macro M(A) A+2 #end", "str(2*M(1),0,0)", "4" },
        { "#macro M(A) A*A #end", "str(M(1+1),0,0)", "4" },
        { "#macro M(A) #local B = A; B; #end #declare C = M(3)", "str(C,0,0)",
          "3" },
        { "#declare V = <1,2>; #declare W = V + 1;", "str(W.y,0,0)", "3" },
        { "#declare T = texture { pigment { rgb 1 } } #declare U = T;",
          "str(1,0,0)", "1" },
        { "#declare A = 2;", "vstr(3, <0 #if (1) -A #end, 0, 0>, \" \", 0, 0)",
          "-2 0 0" },
        { "", "str(defined(A),0,0)", "0" },
        { "#declare A = 1;", "str(defined(A),0,0)", "1" },
        { "#declare C = rgb <1,2,3,.5>;", "str(C.filter,0,1)", "0.5" },
        { "#declare C = color rgbt <1,2,3,.5>*2;", "str(C.transmit,0,0)", "1" },
        { "#declare V = vturbulence(2,0.5,6,<1,2,3>);", "str(V.x < 2,0,0)",
          NULL },
    };
    (void)state;
    check_all(checks, sizeof checks / sizeof *checks - 1);
}

static void test_errors(void **state)
{
    static const struct {
        const char *text, *error;
    } checks[] = {
        { "#declare A = 2 = 1;",
          "1:16: error: '=' must be inside parentheses: (a = b)" },
        { "#declare A = 2 > 1;",
          "1:16: error: '>' must be inside parentheses: (a > b)" },
        { "#if (1 == 1) #end", "1:8: error: this operator is written '='" },
        { "#declare A = 2 ^ 3;", "1:16: error: '^' is not an operator" },
        { "#declare A = sin(1,2);",
          "1:19: error: sin() wants no more than 1 argument" },
        { "#declare A = atan2(1);",
          "1:14: error: atan2() wants 2 arguments, found 1" },
        { "#declare A = \"a\" + \"b\";",
          "1:18: error: strings can only be compared and joined with "
          "concat()" },
        { "#declare A = 1 + \"b\";",
          "1:16: error: this operator has a number on its left and a string "
          "on its right" },
        { "#declare A = array[2] {1};",
          "1:25: error: expected 2 values in these braces, found 1" },
        { "#declare A = array[0];",
          "1:20: error: the size of an array must be at least 1, found 0" },
        { "#declare A = array[2] {1,2} #declare B = A + 1;",
          "1:42: error: expected a value, found 'A', which is an array" },
        { "#declare A = array[2][2]; #declare B = A[1];",
          "1:43: error: this array has 2 dimensions, but only 1 subscript is "
          "given" },
        { "#declare A = x.w;", "1:16: error: 'w' is not a component" },
        { "#declare A = <1,2>.z;",
          "1:20: error: a vector with 2 components has no component 'z'" },
        { "#declare A = <1>;",
          "1:16: error: a vector has two components at least" },
        { "#declare A = <1,2,3,4,5,6>;",
          "1:25: error: a vector has 5 components at most" },
        { "#declare A = vlength(<1,2,3,4>);",
          "1:22: error: expected a vector, found a vector with 4" },
        { "#declare A = 2*rgb 1;",
          "1:16: error: 'rgb' is only allowed at the beginning of a colour" },
        { "#declare A = rand(3);",
          "1:14: error: rand() wants what seed() gave, found 3" },
        { "#declare A = ln(0);", "1:14: error: 0 has no logarithm" },
        { "#declare A = substr(\"abc\",3,2);",
          "1:14: error: the string has 3 characters" },
        { "#declare f = function(a) {a^2}",
          "1:28: error: '^' is not an operator" },
        { "#declare f = function(a) {f(a)}",
          "1:27: error: expected a number or a parameter of the function" },
        { "#declare f = function(a) {a} #declare A = f(1,2);",
          "1:46: error: f() wants no more than 1 argument" },
        { "#declare f = function(a) {sum(i,1,1e12,i)} #declare A = f(1);",
          "1:57: error: this call of 'f' takes more than 50000000 steps" },
        { "#declare A = sum(i,1,2,i);",
          "1:14: error: sum() can be used inside function { } only" },
        { "#declare A = srgb 0.5;",
          "1:14: error: colours in sRGB need to know the scene's "
          "assumed_gamma" },
        { "sphere { <0,0,0>, x }",
          "1:19: error: expected a number for 'radius', found a vector with "
          "3 components" },
        { "poly { 99, <1> }", "1:8: error: 'order' must be from 2 to" },
        { "camera { location <0,1/0,0> }",
          "1:19: error: 'location' is not a finite number" },
    };
    unsigned wrong = 0;
    (void)state;
    for (size_t i = 0; i < sizeof checks / sizeof *checks; i++) {
        bool ok;
        char *printed = scene_text_run(checks[i].text, &ok);
        if (ok || !strstr(printed, checks[i].error)) {
            print_error("%s\n    expected %s\n    found %s\n", checks[i].text,
                        checks[i].error, printed);
            wrong++;
        }
        free(printed);
    }
    assert_int_equal(wrong, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_arrays),         cmocka_unit_test(test_random),
        cmocka_unit_test(test_user_functions), cmocka_unit_test(test_probes),
        cmocka_unit_test(test_identifiers),    cmocka_unit_test(test_errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
