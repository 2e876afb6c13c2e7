package badlog.window.export.figure

import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.toArgb

/** Returns [text] as one line of at most [longest] characters, without those that XML does not allow. */
internal fun plainLine(text: String, longest: Int): String {
    val line = StringBuilder()
    var i = 0
    while (i < text.length) {
        val code = text.codePointAt(i)
        i += Character.charCount(code)
        val isAllowed = !Character.isISOControl(code) && code !in SURROGATES && code !in NO_LETTERS
        line.appendCodePoint(if (isAllowed) code else ' '.code)
    }
    val letters = line.codePointCount(0, line.length)
    if (letters <= longest) return line.toString()
    val head = line.substring(0, line.offsetByCodePoints(0, longest / 2))
    val tail = line.substring(line.offsetByCodePoints(0, letters - (longest - longest / 2 - 1)))
    return "$head…$tail"
}

/** Returns [color] as SVG writes it: `#rrggbb`. */
internal fun hexOf(color: Color): String = "#%06x".format(color.toArgb() and 0xFFFFFF)

private val SURROGATES = 0xD800..0xDFFF
private val NO_LETTERS = 0xFFFE..0xFFFF
