/** The fine grid of a physical sky's fields: rows of the view's height, turns of the azimuth from the sun. */

export const ROWS = 129;
export const TURNS = 91;
