"""The shading languages that skies are written in: how each spells a function, a constant and a vector."""

import re
from dataclasses import dataclass, replace

from skydome.ground.arguments import require_word

NUMBER = re.compile(r"(?<![\w.])(\d+\.\d*(?:e[+-]?\d+)?)(?![\w.])")
C_FUNCTIONS = {"exp": "expf", "sqrt": "sqrtf", "asin": "asinf", "max": "fmaxf", "min": "fminf", "cos": "cosf"}
C_FUNCTIONS |= {"floor": "floorf", "sin": "sinf", "log": "logf", "pow": "powf", "atan2": "atan2f", "acos": "acosf"}


@dataclass(frozen=True)
class Language:
    """How a language spells what the generated code needs.

    `let` declares a constant, `scalar` heads a function of numbers that returns one, `colour` heads the function of a
    direction, `answer` returns three numbers. `direction` spells the components of the direction. `many` heads a
    function of a direction to `count` numbers, which `put` writes one by one, or `together` returns. Where the sky's
    numbers are not constants, `reader` declares how they are read, `read` reads one by an index, `whole` makes an index
    of a number, and `colour_of` and `many_of` head the functions. `free` and `free_of` head the function of a
    direction, a sun and a turbidity.
    """

    name: str
    comment: str
    let: str
    argument: str
    scalar: str
    colour: str
    answer: str
    direction: tuple[str, str, str]
    many: str
    put: str = "values[{k}] = {value};"
    together: str = ""
    suffix: str = ""
    functions: tuple[tuple[str, str], ...] = ()
    reader: str = ""
    read: str = "SKYDOME_NUMBER({k})"
    whole: str = "int({x})"
    colour_of: str = ""
    many_of: str = ""
    free: str = ""
    free_of: str = ""

    def spelled(self, code: str) -> str:
        """Code in this language's spelling of numbers and functions."""
        if self.suffix:
            code = NUMBER.sub(lambda match: match.group(1) + self.suffix, code)
        for general, own in self.functions:
            code = re.sub(rf"\b{general}\(", f"{own}(", code)
        return code

    def constant(self, name: str, expression: str) -> str:
        """One indented line that declares a constant."""
        return "    " + self.spelled(self.let.format(name=name, expression=expression))

    def scalar_function(self, name: str, arguments: list[str], lines: list[tuple[str, str]], result: str) -> str:
        """A function of numbers: constants by name and expression, then the result."""
        head = self.scalar.format(name=name, arguments=", ".join(self.argument.format(name=a) for a in arguments))
        body = [self.constant(*line) for line in lines]
        return "\n".join([f"{head} {{", *body, self.spelled(f"    return {result};"), "}"])

    def under_any_sun(self) -> "Language":
        """The same with functions of a direction, a sun and a turbidity."""
        return replace(self, colour=self.free, colour_of=self.free_of or self.free)

    def reading(self) -> "Language":
        """The same with functions that read their sky's numbers."""
        return replace(self, colour=self.colour_of or self.colour, many=self.many_of or self.many)

    def colour_function(self, name: str, lines: list[tuple[str, str]], result: tuple[str, str, str]) -> str:
        """The function of a direction: constants by name and expression, then red, green and blue."""
        body = [self.constant(*line) for line in lines]
        answer = "    " + self.spelled(self.answer.format(r=result[0], g=result[1], b=result[2]))
        return "\n".join([f"{self.colour.format(name=name)} {{", *body, answer, "}"])

    def many_function(self, name: str, lines: list[tuple[str, str]], results: list[str]) -> str:
        """The function of a direction to many numbers: constants by name and expression, then the numbers."""
        body = [self.constant(*line) for line in lines]
        answers = [self.put.format(k=k, value=result) for k, result in enumerate(results)]
        if self.together:
            answers = [self.together.format(count=len(results), all=", ".join(results))]
        answers = ["    " + self.spelled(answer) for answer in answers]
        return "\n".join([f"{self.many.format(name=name, count=len(results))} {{", *body, *answers, "}"])


GLSL_READER = """#ifndef SKYDOME_NUMBER  // number k of the sky: a texture of one float channel, 256 texels wide
uniform highp sampler2D skydome_numbers;
#define SKYDOME_NUMBER(k) texelFetch(skydome_numbers, ivec2((k) & 255, (k) >> 8), 0).r
#endif"""
HLSL_READER = """#ifndef SKYDOME_NUMBER  // number k of the sky
Buffer<float> skydome_numbers;
#define SKYDOME_NUMBER(k) skydome_numbers[k]
#endif"""
WGSL_READER = """@group(0) @binding(0) var<storage, read> skydome_numbers: array<f32>;

fn skydome_number(k: i32) -> f32 {
    return skydome_numbers[k];
}"""
ARRAY_READER = """#ifndef SKYDOME_NUMBER  // number k of the sky
#define SKYDOME_NUMBER(k) numbers[k]
#endif"""

XYZ = ("direction.x", "direction.y", "direction.z")
INDEXED = ("direction[0]", "direction[1]", "direction[2]")

GLSL = Language(
    name="glsl", comment="//", let="float {name} = {expression};", argument="float {name}",
    scalar="float {name}({arguments})", colour="vec3 {name}(vec3 direction)",
    answer="return vec3({r}, {g}, {b});", direction=XYZ,
    many="void {name}(vec3 direction, out float values[{count}])", reader=GLSL_READER,
    free="vec3 {name}(vec3 direction, vec3 sun, float turbidity)",
)  # fmt: skip
HLSL = Language(
    name="hlsl", comment="//", let="float {name} = {expression};", argument="float {name}",
    scalar="float {name}({arguments})", colour="float3 {name}(float3 direction)",
    answer="return float3({r}, {g}, {b});", direction=XYZ,
    many="void {name}(float3 direction, out float values[{count}])", reader=HLSL_READER,
    free="float3 {name}(float3 direction, float3 sun, float turbidity)",
)  # fmt: skip
WGSL = Language(
    name="wgsl", comment="//", let="let {name} = {expression};", argument="{name}: f32",
    scalar="fn {name}({arguments}) -> f32", colour="fn {name}(direction: vec3<f32>) -> vec3<f32>",
    answer="return vec3<f32>({r}, {g}, {b});", direction=XYZ,
    many="fn {name}(direction: vec3<f32>) -> array<f32, {count}>", together="return array<f32, {count}>({all});",
    free="fn {name}(direction: vec3<f32>, sun: vec3<f32>, turbidity: f32) -> vec3<f32>",
    reader=WGSL_READER, read="skydome_number({k})", whole="i32({x})",
)  # fmt: skip
OSL = Language(
    name="osl", comment="//", let="float {name} = {expression};", argument="float {name}",
    scalar="float {name}({arguments})", colour="color {name}(vector direction)",
    answer="return color({r}, {g}, {b});", direction=INDEXED,
    many="void {name}(vector direction, output float values[{count}])", reader=ARRAY_READER, whole="(int)({x})",
    colour_of="color {name}(vector direction, float numbers[])",
    free="color {name}(vector direction, vector sun, float turbidity)",
    free_of="color {name}(vector direction, vector sun, float turbidity, float numbers[])",
    many_of="void {name}(vector direction, float numbers[], output float values[{count}])",
)  # fmt: skip
C = Language(
    name="c", comment="//", let="const float {name} = {expression};", argument="float {name}",
    scalar="static float {name}({arguments})", colour="void {name}(const float direction[3], float rgb[3])",
    answer="rgb[0] = {r}; rgb[1] = {g}; rgb[2] = {b};", direction=INDEXED, suffix="f",
    many="void {name}(const float direction[3], float values[{count}])", reader=ARRAY_READER, whole="(int)({x})",
    colour_of="void {name}(const float direction[3], const float numbers[], float rgb[3])",
    free="void {name}(const float direction[3], const float sun[3], float turbidity, float rgb[3])",
    free_of="void {name}(const float direction[3], const float sun[3], float turbidity, const float numbers[], "
    "float rgb[3])",
    many_of="void {name}(const float direction[3], const float numbers[], float values[{count}])",
    functions=tuple(C_FUNCTIONS.items()),
)  # fmt: skip

LANGUAGES = (GLSL, WGSL, HLSL, OSL, C)


def language(name: str) -> Language:
    """The language of that name; ValueError lists those there are.

    >>> language("wgsl").answer
    'return vec3<f32>({r}, {g}, {b});'
    """
    known = {entry.name: entry for entry in LANGUAGES}
    return known[require_word(name, known, "language")]


def number(value: float) -> str:
    """A number with nine significant digits and a decimal point, in brackets where negative."""
    text = f"{float(value):.9g}"
    if "." not in text:
        mantissa, mark, exponent = text.partition("e")
        text = f"{mantissa}.0{mark}{exponent}"
    return f"({text})" if text.startswith("-") else text
