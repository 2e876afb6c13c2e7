package badlog.site

import org.commonmark.Extension
import org.commonmark.ext.gfm.tables.TablesExtension
import org.commonmark.ext.heading.anchor.IdGenerator
import org.commonmark.node.AbstractVisitor
import org.commonmark.node.BulletList
import org.commonmark.node.FencedCodeBlock
import org.commonmark.node.Heading
import org.commonmark.node.Image
import org.commonmark.node.Link
import org.commonmark.node.Node
import org.commonmark.node.Paragraph
import org.commonmark.parser.Parser
import org.commonmark.renderer.html.AttributeProvider
import org.commonmark.renderer.html.HtmlRenderer
import java.nio.file.Path
import kotlin.io.path.readText

/** Reads the Markdown files of [root], and rewrites their links to the addresses of [plan]. */
internal class GuideReader(private val root: Path, private val plan: SitePlan) {
    private val extensions: List<Extension> = listOf(TablesExtension.create())
    private val parser = Parser.builder().extensions(extensions).build()

    /**
     * Reads the page at [path].
     *
     * @throws IllegalStateException if it has no heading, or links to a file that does not exist.
     */
    fun read(path: String): Guide {
        val address = plan.pages.getValue(path)
        val document = parser.parse(root.resolve(path).readText())
        val anchors = anchorsOf(document)
        val sections = sectionsOf(document, anchors)
        val copied = LinkRewriter(path, address, plan).also(document::accept).copied
        val drawn = HashMap<Node, String>()
        document.accept(object : AbstractVisitor() {
            override fun visit(block: FencedCodeBlock) {
                if (block.info == "mermaid") drawn[block] = Flowchart.of(block.literal).html()
            }
        })
        val html = HtmlRenderer.builder().extensions(extensions)
            .attributeProviderFactory { GuideAttributes(anchors) }
            .nodeRendererFactory { HeadingRenderer(it, anchors) }
            .nodeRendererFactory { FlowchartRenderer(it, drawn) }
            .build().render(document)
        return Guide(
            path = path,
            address = address,
            title = checkNotNull(sections.firstOrNull()?.heading) { "$path has no heading; begin it with “# Title”." },
            summary = children(document).firstOrNull { it is Paragraph }?.let { plainText(it) }.orEmpty(),
            html = html,
            sections = sections,
            lists = listsOf(document),
            copied = copied,
        )
    }

    /** Returns the plain text of the page at [path], without its code. */
    fun prose(path: String): String = plainText(parser.parse(root.resolve(path).readText()), includesCode = false)

    private fun anchorsOf(document: Node): Map<Heading, String> {
        val ids = IdGenerator.builder().defaultId("section").build()
        return children(document).filterIsInstance<Heading>().associateWith { ids.generateId(plainText(it)) }
    }

    private fun sectionsOf(document: Node, anchors: Map<Heading, String>): List<Guide.Section> {
        val sections = ArrayList<Guide.Section>()
        for (node in children(document)) {
            val last = sections.lastOrNull()
            if (node is Heading) {
                sections += Guide.Section(node.level, anchors.getValue(node), plainText(node), "")
            } else if (last != null) {
                sections[sections.lastIndex] = last.copy(text = "${last.text} ${plainText(node)}".trim())
            }
        }
        return sections
    }

    private fun listsOf(document: Node): List<Pair<String, List<Pair<String, String>>>> {
        val lists = LinkedHashMap<String, MutableList<Pair<String, String>>>()
        var heading = ""
        for (node in children(document)) {
            if (node is Heading && node.level == 2) heading = plainText(node)
            if (node !is BulletList || heading.isEmpty()) continue
            lists.getOrPut(heading) { ArrayList() } += children(node).mapNotNull { item ->
                item.firstChild?.let(::children)?.filterIsInstance<Link>()?.firstOrNull()?.let { plainText(it) to it.destination }
            }
        }
        return lists.map { (title, links) -> title to links }
    }
}

internal fun children(node: Node): List<Node> = generateSequence(node.firstChild) { it.next }.toList()

/** Adds anchors to headings, and lets pictures load when they come into sight. */
private class GuideAttributes(private val anchors: Map<Heading, String>) : AttributeProvider {
    override fun setAttributes(node: Node, tagName: String, attributes: MutableMap<String, String>) {
        if (node is Heading) anchors[node]?.let { attributes["id"] = it }
        if (node is Image) attributes["loading"] = "lazy"
        if (node is FencedCodeBlock && tagName == "pre") attributes["tabindex"] = "0"
    }
}
