// Written by scripts/export_explorer.py from the package's own formulas.
export const FORMULA = `
float skydome_channel(float up, float half_square, float angle, float level, float a, float b, float c, float d, float e, float f, float g, float h, float i) {
    float cosine = 1.0 - 2.0 * half_square;
    float square = cosine * cosine;
    float spread = max((1.0 - h) * (1.0 - h) + 4.0 * h * half_square, 1.0e-12);
    float chi = (1.0 + square) / (spread * sqrt(spread));
    float gradation = 1.0 + a * exp(b / max(up + 0.0, 1.0e-06));
    float indicatrix = c + d * exp(e * angle) + f * square + g * chi + i * sqrt(up);
    return max(0.0, level * gradation * indicatrix);
}
float hosek_channel(float up, float half_square, float angle, float level, float a, float b, float c, float d, float e, float f, float g, float h, float i) {
    float cosine = 1.0 - 2.0 * half_square;
    float square = cosine * cosine;
    float spread = max((1.0 - h) * (1.0 - h) + 4.0 * h * half_square, 1.0e-12);
    float chi = (1.0 + square) / (spread * sqrt(spread));
    float gradation = 1.0 + a * exp(b / max(up + 0.01, 1.0e-06));
    float indicatrix = c + d * exp(e * angle) + f * square + g * chi + i * sqrt(up);
    return max(0.0, level * gradation * indicatrix);
}
float skydome_angle(float half_square) {
    float nearer = min(half_square, 1.0 - half_square);
    float angle = sqrt(nearer) * (2.0 + nearer * (0.333332285 + nearer * (0.150055146 + nearer * (0.0881832338 + nearer * (0.0716284764 + nearer * ((-0.0140411491) + nearer * (0.214800021 + nearer * ((-0.271832516) + nearer * (0.247826976)))))))));
    float behind = max(0.0, min(1.0, (half_square - 0.5) * 1.0e9));
    return angle + behind * (3.14159265 - 2.0 * angle);
}
`;

export const INPUTS: Record<string, string> = {
  "east": "east",
  "north": "north",
  "view_z": "up",
  "distance": "distance_to_sun",
  "sqrt_up": "sqrt(up)",
  "log_up": "log(up + 0.02)",
  "inverse_up": "1.0 / (up + 0.1)",
  "sqrt_distance": "sqrt(distance_to_sun)",
  "log_distance": "log(distance_to_sun + 0.05)",
  "cos_angle": "1.0 - 0.5 * distance_to_sun * distance_to_sun"
};
