package badlog.page.parts

import badlog.page.dom.Icon
import badlog.page.dom.element
import badlog.page.dom.focusInPlace
import kotlinx.browser.document
import org.w3c.dom.HTMLElement

/**
 * Changes the children of this element to match [nodes]. An element with the same key and tag as before is kept and updated, so that focus,
 * scrolling and typed text stay, too. Nodes are compared only with the previous nodes, because reading from the page costs more.
 */
internal fun HTMLElement.patch(nodes: List<Node>) {
    val before = shown
    // The most frequent cases: nothing comes, goes or moves, or something comes at the end.
    if (before.size <= nodes.size && before.indices.all { before[it].node?.isSameAs(nodes[it]) == true }) {
        for (i in before.indices) before[i].update(nodes[i])
        val next = if (before.isEmpty()) firstElementChild else before.last().nextElementSibling
        if (before.size < nodes.size) {
            shown = before + (before.size until nodes.size).map { i ->
                val child = made(nodes[i], idOf(nodes[i], i))
                insertBefore(child, next)
                child.update(nodes[i])
                child
            }
        }
        return
    }
    val focused = document.activeElement
    val known = before.associateBy { it.asDynamic().badlogId as String }
    val ids = nodes.mapIndexed { i, node -> idOf(node, i) }
    val wanted = ids.toHashSet()
    // First, so that those behind them need not be moved, which would take the focus from them.
    for ((id, child) in known) if (id !in wanted) child.remove()
    var place = firstElementChild
    shown = ids.zip(nodes) { id, node ->
        val child = known[id] ?: made(node, id)
        if (child === place) place = child.nextElementSibling else insertBefore(child, place)
        child.update(node)
        child
    }
    // An element that was moved has lost the focus.
    if (focused != null && focused !== document.activeElement && contains(focused)) focused.focusInPlace()
}

private fun idOf(node: Node, place: Int) = "${node.tag} ${node.key.ifEmpty { "$place" }}"

private fun made(node: Node, id: String): HTMLElement = elementNamed(node.tag).apply {
    asDynamic().badlogId = id
    node.icon?.let { appendChild(it.draw()) }
    if (node.tag == "button") setAttribute("type", "button")
    if (node.press != null) addEventListener("click", { this.node?.press?.invoke() })
    if (node.hint != null) addEventListener("pointerenter", { title = this.node?.hint?.invoke().orEmpty() })
    for (type in node.on.keys) addEventListener(type, { event -> this.node?.on?.get(type)?.invoke(event) })
}

private fun elementNamed(tag: String) =
    if (tag in PICTURE_TAGS) document.createElementNS(Icon.SVG, tag).unsafeCast<HTMLElement>() else element(tag)

/** The tags of pictures that take the colors of the style sheet. */
private val PICTURE_TAGS = listOf("svg", "path")

/** The node from which the element was made last. */
private var HTMLElement.node: Node?
    get() = asDynamic().badlogNode.unsafeCast<Node?>()
    set(value) {
        asDynamic().badlogNode = value
    }

/** The elements that were made in it. */
private var HTMLElement.shown: List<HTMLElement>
    get() = asDynamic().badlogShown.unsafeCast<List<HTMLElement>?>().orEmpty()
    set(value) {
        asDynamic().badlogShown = value
    }

private fun HTMLElement.update(node: Node) {
    val before = this.node
    if (before === node) return
    this.node = node
    if (before?.className.orEmpty() != node.className) className = node.className
    if (before?.attributes !== node.attributes) {
        for (name in before?.attributes.orEmpty().keys) if (node.attributes[name] == null) removeAttribute(name)
        for ((name, value) in node.attributes) if (value != null && before?.attributes?.get(name) != value) setAttribute(name, value)
    }
    // The attributes do not count any more once a person has pressed the box, or typed.
    if (node.attributes["type"] == "checkbox") asDynamic().checked = node.attributes["checked"] != null
    if (node.tag == "input" && node.attributes["value"] != before?.attributes?.get("value")) asDynamic().value = node.attributes["value"]
    if (node.text != before?.text) {
        textContent = node.text.orEmpty()
        // A tooltip that is still there shows the former value.
        if (node.hint != null) removeAttribute("title")
        shown = emptyList()
    }
    if (node.text == null && node.icon == null) patch(node.children)
    node.draw?.invoke(this)
}
