package badlog.page.parts

import badlog.page.dom.element
import badlog.page.dom.showText
import org.w3c.dom.HTMLElement
import org.w3c.dom.asList

/**
 * Makes the children of this element what [nodes] say. An element with the same key and tag as before stays and is changed, so that focus,
 * scrolling and what a person has typed stay, too.
 */
internal fun HTMLElement.patch(nodes: List<Node>) {
    val known = HashMap<String, HTMLElement>()
    for (child in children.asList()) known[child.asDynamic().badlogId as String? ?: continue] = child.unsafeCast<HTMLElement>()
    val ids = nodes.mapIndexed { i, node -> "${node.tag} ${node.key.ifEmpty { "$i" }}" }
    val wanted = ids.toHashSet()
    // First, so that those behind them need not be moved, which would take the focus from them.
    for ((id, child) in known) if (id !in wanted) child.remove()
    var place = firstElementChild
    for ((id, node) in ids.zip(nodes)) {
        val child = known[id] ?: made(node, id)
        child.update(node)
        if (child === place) place = place.nextElementSibling else insertBefore(child, place)
    }
}

private fun made(node: Node, id: String): HTMLElement = element(node.tag).apply {
    asDynamic().badlogId = id
    node.icon?.let { appendChild(it.draw()) }
    for (type in node.on.keys) addEventListener(type, { event -> this.node?.on?.get(type)?.invoke(event) })
}

/** What the element was made to be last. */
private var HTMLElement.node: Node?
    get() = asDynamic().badlogNode.unsafeCast<Node?>()
    set(value) {
        asDynamic().badlogNode = value
    }

private fun HTMLElement.update(node: Node) {
    val before = this.node
    this.node = node
    if (className != node.className) className = node.className
    for (name in before?.attributes.orEmpty().keys) if (name !in node.attributes) removeAttribute(name)
    for ((name, value) in node.attributes) if (getAttribute(name) != value) setAttribute(name, value)
    if (node.text == null && before?.text != null) textContent = ""
    if (node.text != null) {
        showText(node.text)
    } else if (node.icon == null) {
        patch(node.children)
    }
}
