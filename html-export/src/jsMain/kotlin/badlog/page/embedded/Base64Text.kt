package badlog.page.embedded

import org.w3c.dom.Element
import org.w3c.dom.Node
import org.w3c.dom.Text

/**
 * The base64 text of an element, piece by piece. It can be hundreds of megabytes, in one text node or in thousands, so
 * it is never put together.
 */
internal class Base64Text(element: Element) {
    private var node: Node? = element.firstChild
    private var offset = 0

    /** The next [characters], a multiple of four so that a piece ends where a group does; fewer and then null at the end. */
    fun next(characters: Int = PIECE): String? {
        var piece = ""
        while (piece.length < characters) {
            val text = node?.unsafeCast<Text>() ?: break
            val taken = minOf(characters - piece.length, text.length - offset)
            piece += text.substringData(offset, taken)
            offset += taken
            if (offset == text.length) {
                node = text.nextSibling
                offset = 0
            }
        }
        return piece.ifEmpty { null }
    }

    private companion object {
        const val PIECE = 1 shl 20
    }
}
