/// The number of pictures that are drawn over each other: each needs a texture unit of the terrain's shader.
export const mostDraped = 4;
