// Written by scripts/export_explorer.py from the package's own formulas.
export function skydome_channel(up: number, half_square: number, angle: number, level: number, a: number, b: number, c: number, d: number, e: number, f: number, g: number, h: number, i: number): number {
    const cosine = 1.0 - 2.0 * half_square;
    const square = cosine * cosine;
    const spread = Math.max((1.0 - h) * (1.0 - h) + 4.0 * h * half_square, 1.0e-12);
    const chi = (1.0 + square) / (spread * Math.sqrt(spread));
    const gradation = 1.0 + a * Math.exp(b / Math.max(up + 0.0, 1.0e-06));
    const indicatrix = c + d * Math.exp(e * angle) + f * square + g * chi + i * Math.sqrt(up);
    return Math.max(0.0, level * gradation * indicatrix);
}
export function hosek_channel(up: number, half_square: number, angle: number, level: number, a: number, b: number, c: number, d: number, e: number, f: number, g: number, h: number, i: number): number {
    const cosine = 1.0 - 2.0 * half_square;
    const square = cosine * cosine;
    const spread = Math.max((1.0 - h) * (1.0 - h) + 4.0 * h * half_square, 1.0e-12);
    const chi = (1.0 + square) / (spread * Math.sqrt(spread));
    const gradation = 1.0 + a * Math.exp(b / Math.max(up + 0.01, 1.0e-06));
    const indicatrix = c + d * Math.exp(e * angle) + f * square + g * chi + i * Math.sqrt(up);
    return Math.max(0.0, level * gradation * indicatrix);
}
export function skydome_angle(half_square: number): number {
    const nearer = Math.min(half_square, 1.0 - half_square);
    const angle = Math.sqrt(nearer) * (2.0 + nearer * (0.333332285 + nearer * (0.150055146 + nearer * (0.0881832338 + nearer * (0.0716284764 + nearer * ((-0.0140411491) + nearer * (0.214800021 + nearer * ((-0.271832516) + nearer * (0.247826976)))))))));
    const behind = Math.max(0.0, Math.min(1.0, (half_square - 0.5) * 1.0e9));
    return angle + behind * (3.14159265 - 2.0 * angle);
}
