package badlog.page.parts

import badlog.page.dom.Icon
import org.w3c.dom.HTMLElement
import org.w3c.dom.events.Event

/**
 * The intended content of an element of the page, see [patch].
 *
 * @property key identifies the element among its siblings; empty if its position identifies it.
 * @property text its text; null if it has [children] instead. It becomes a text node, so nothing in a file can become markup.
 * @property attributes its attributes, without those that are null.
 * @property icon the icon at its beginning; null if there is none.
 * @property hint returns the tooltip of a [text] when the pointer comes to it.
 * @property press the effect of a press on a button.
 * @property draw draws the content of a canvas, which must be on the page.
 * @property on the handlers of other events, by event type.
 */
internal class Node(
    val tag: String,
    val className: String = "",
    val text: String? = null,
    val key: String = "",
    val attributes: Map<String, String?> = emptyMap(),
    val icon: Icon? = null,
    val hint: (() -> String)? = null,
    val press: (() -> Unit)? = null,
    val draw: ((HTMLElement) -> Unit)? = null,
    val on: Map<String, (Event) -> Unit> = emptyMap(),
    val children: List<Node> = emptyList(),
) {
    /** Returns whether this node and [other] describe the same element. */
    fun isSameAs(other: Node): Boolean = tag == other.tag && key == other.key
}
