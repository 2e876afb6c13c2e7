package badlog.site

import org.commonmark.node.FencedCodeBlock
import org.commonmark.node.Node
import org.commonmark.renderer.NodeRenderer
import org.commonmark.renderer.html.HtmlNodeRendererContext

/** A Mermaid flowchart: boxes, and [arrows] from one to another. */
internal class Flowchart private constructor(val arrows: List<Arrow>) {
    /** An arrow between two boxes, each known by its text; [label] is written beside it, empty for none. */
    class Arrow(val from: String, val label: String, val to: String)

    /** Returns the chart as a drawing, followed by a list for readers who cannot see it. */
    fun html(): String = drawingOf(this).let {
        "<figure class=\"flowchart\">\n$it\n<details><summary>The same as a list</summary>\n${list()}</details>\n</figure>\n"
    }

    /** Returns a list of the boxes, each with the ends of its arrows. */
    private fun list(): String = arrows.groupBy {
        it.from
    }.entries.joinToString("\n", "<ul class=\"arrows\">\n", "\n</ul>\n") { (from, arrows) ->
        val ends = arrows.joinToString(", ") { (if (it.label.isEmpty()) "" else escape(it.label) + " ") + "<b>${escape(it.to)}</b>" }
        "<li><b>${escape(from)}</b> → $ends</li>"
    }

    internal companion object {
        private val ARROW = Regex("""^\s*(\w+)(?:\[(.+?)])? (?:-- (.+?) )?--> (\w+)(?:\[(.+?)])?\s*$""")

        /**
         * Reads the arrows of [text].
         *
         * @throws IllegalStateException if a line is neither the chart's first nor an arrow.
         */
        fun of(text: String): Flowchart {
            val lines = text.lines().filter { it.isNotBlank() }.drop(1)
            val found = lines.map { checkNotNull(ARROW.find(it)) { "“$it” is not an arrow of a flowchart; write “a --> b”." }.groupValues }
            val names = HashMap<String, String>()
            for (line in found) {
                if (line[2].isNotEmpty()) names[line[1]] = line[2]
                if (line[5].isNotEmpty()) names[line[4]] = line[5]
            }
            return Flowchart(found.map { Arrow(names[it[1]] ?: it[1], it[3], names[it[4]] ?: it[4]) })
        }
    }
}

/** Writes the code blocks of [drawn] as the HTML that replaces them, and all others as code. */
internal class FlowchartRenderer(private val context: HtmlNodeRendererContext, private val drawn: Map<Node, String>) : NodeRenderer {
    override fun getNodeTypes(): Set<Class<out Node>> = setOf(FencedCodeBlock::class.java)

    override fun render(node: Node) {
        val html = drawn[node]
        val writer = context.writer
        writer.line()
        if (html != null) {
            writer.raw(html)
        } else {
            val block = node as FencedCodeBlock
            val language = block.info.orEmpty().substringBefore(' ')
            writer.tag("pre", context.extendAttributes(node, "pre", emptyMap()))
            writer.tag("code", if (language.isEmpty()) emptyMap() else mapOf("class" to "language-$language"))
            writer.text(block.literal)
            writer.tag("/code")
            writer.tag("/pre")
        }
        writer.line()
    }
}
