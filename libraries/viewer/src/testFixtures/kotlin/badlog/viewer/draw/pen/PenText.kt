package badlog.viewer.draw.pen

/**
 * A text on a picture of [PRIMITIVE_WIDTH] by [PRIMITIVE_HEIGHT]. Fonts differ, and with them the pixels: pens agree if each covers the
 * rectangle that follows from the width that it measures.
 *
 * @param isClipped whether only the part to the left of [CLIP_RIGHT] is shown.
 */
class PenText(
    private val x: Double,
    private val side: TextSide = TextSide.RIGHT,
    private val isBold: Boolean = false,
    private val halo: Int? = null,
    private val isClipped: Boolean = false,
) {
    /** Writes the text with [pen]. */
    fun writeWith(pen: Pen) {
        if (isClipped) pen.clip(0.0, 0.0, CLIP_RIGHT, PRIMITIVE_HEIGHT.toDouble()) { write(pen) } else write(pen)
    }

    /** Returns the rectangle of the text. Its width comes from [widthOf], called with the text, the font size, and whether it is bold. */
    fun boxFor(widthOf: (String, Double, Boolean) -> Double): PenBox {
        val width = widthOf(TEXT, LETTERS, isBold)
        val left = when (side) {
            TextSide.LEFT -> x - width
            TextSide.CENTER -> x - width / 2
            TextSide.RIGHT -> x
        }
        val outline = if (halo == null) 0.0 else OUTLINE
        val baseline = MIDDLE + BASELINE * LETTERS
        val right = left + width + outline
        return PenBox(
            left - outline,
            baseline - SMALL_LETTERS * LETTERS - outline,
            if (isClipped) minOf(right, CLIP_RIGHT) else right,
            baseline + outline,
        )
    }

    private fun write(pen: Pen) = pen.text(TEXT, x, MIDDLE, LETTERS, BLACK, side, isBold, halo)
}

/** Texts on each side of their places, by name. */
val PEN_TEXTS: Map<String, PenText> = mapOf(
    "a text" to PenText(x = 20.0),
    "a text that ends at its place" to PenText(x = 190.0, TextSide.LEFT),
    "a bold text around its place, with a halo" to PenText(x = 100.0, TextSide.CENTER, isBold = true, halo = (0xFF shl 24) or 0xFFE080),
    "a clipped text" to PenText(x = 20.0, isClipped = true),
)

/** The tolerance in pixels between a text and its [PenText.boxFor]: letters do not begin right at their left edge. */
const val TEXT_TOLERANCE: Double = 3.0

/** Only letters of equal height. */
private const val TEXT = "nearer means sooner"
private const val LETTERS = 16.0
private const val MIDDLE = 50.0
private const val CLIP_RIGHT = 100.0
private const val BLACK = 0xFF shl 24

/** The width of a halo's outline. */
private const val OUTLINE = 1.5

/** The height of small letters as a fraction of the font size: 0.52 to 0.55 in fonts without serifs. */
private const val SMALL_LETTERS = 0.53
