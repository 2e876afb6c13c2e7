package badlog.page.embedded

import org.w3c.dom.Element
import org.w3c.dom.Node
import org.w3c.dom.Text

/**
 * The base64 text of an [element], piece by piece. It can be hundreds of megabytes long, in one text node or in thousands, so it is never
 * concatenated. More of it may arrive while the page loads.
 */
internal class Base64Text(private val element: Element) {
    private var node: Node? = null
    private var offset = 0

    /**
     * Returns the next piece of a line; null if there is no more, or not yet.
     *
     * A piece has at most [PIECE] characters, and a multiple of four if more may follow. The last piece of a line ends with its line feed.
     * Each line can be decoded without the lines before it.
     */
    fun next(): String? {
        var piece = ""
        while (piece.length < PIECE && hasMore()) {
            val text = node.unsafeCast<Text>()
            val isAll = offset == 0 && text.length <= PIECE - piece.length
            // Avoids copying the text of a whole node.
            val taken = if (isAll) text.data else text.substringData(offset, minOf(PIECE - piece.length, text.length - offset))
            val end = taken.indexOf('\n')
            if (end < 0) {
                piece += taken
                offset += taken.length
            } else {
                offset += end + 1
                return piece + taken.substring(0, end + 1)
            }
        }
        return piece.ifEmpty { null }
    }

    private fun hasMore(): Boolean {
        val text = node ?: element.firstChild ?: return false
        node = text
        if (offset < text.unsafeCast<Text>().length) return true
        // The last node may still grow.
        node = text.nextSibling ?: return false
        offset = 0
        return hasMore()
    }

    private companion object {
        const val PIECE = 1 shl 20
    }
}
