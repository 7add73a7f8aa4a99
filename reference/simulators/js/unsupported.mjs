/** An honest reason for which the engine cannot express the scene: an answer `unsupported`. */
export class Unsupported extends Error {}
