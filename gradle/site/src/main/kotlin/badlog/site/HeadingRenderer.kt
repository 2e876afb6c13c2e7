package badlog.site

import org.commonmark.node.Heading
import org.commonmark.node.Node
import org.commonmark.renderer.NodeRenderer
import org.commonmark.renderer.html.HtmlNodeRendererContext

/** Writes headings with a link to themselves. */
internal class HeadingRenderer(private val context: HtmlNodeRendererContext, private val anchors: Map<Heading, String>) : NodeRenderer {
    override fun getNodeTypes(): Set<Class<out Node>> = setOf(Heading::class.java)

    override fun render(node: Node) {
        val writer = context.writer
        val tag = "h${(node as Heading).level}"
        val anchor = anchors[node]
        writer.line()
        writer.tag(tag, context.extendAttributes(node, tag, emptyMap()))
        children(node).forEach(context::render)
        if (anchor != null && node.level > 1) {
            writer.tag("a", mapOf("class" to "anchor", "href" to "#$anchor", "aria-label" to "Link to this section"))
            writer.text("#")
            writer.tag("/a")
        }
        writer.tag("/$tag")
        writer.line()
    }
}
