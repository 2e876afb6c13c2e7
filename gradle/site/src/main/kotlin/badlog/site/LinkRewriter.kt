package badlog.site

import org.commonmark.node.AbstractVisitor
import org.commonmark.node.HtmlBlock
import org.commonmark.node.HtmlInline
import org.commonmark.node.Image
import org.commonmark.node.Link
import org.commonmark.node.Node

/**
 * Rewrites the links and pictures of the page at [path] to addresses on the site, according to [plan]. The page itself is at [address]. A
 * link to a folder of the repository becomes plain text.
 */
internal class LinkRewriter(private val path: String, private val address: String, private val plan: SitePlan) : AbstractVisitor() {
    /** The linked files to copy to the site, each with its address. */
    val copied: MutableMap<String, String> = HashMap()

    override fun visit(link: Link) {
        visitChildren(link)
        val destination = link.destination
        if (OUTSIDE.containsMatchIn(destination) || destination.startsWith("#")) return
        when (val target = targetOf(destination)) {
            is SitePlan.Target.OnSite -> {
                link.destination = relative(target)
                target.copied?.let { copied[it] = target.address }
            }

            else -> unwrap(link)
        }
        if ("#" in destination && link.parent != null) link.destination += "#" + destination.substringAfter('#')
    }

    override fun visit(image: Image) {
        image.destination = picture(image.destination)
    }

    override fun visit(html: HtmlBlock) {
        html.literal = withPictures(html.literal)
    }

    override fun visit(html: HtmlInline) {
        html.literal = withPictures(html.literal)
    }

    private fun withPictures(html: String): String = SOURCE.replace(html) { "src=\"${picture(it.groupValues[1])}\"" }

    private fun picture(destination: String): String {
        val target = targetOf(destination) as? SitePlan.Target.OnSite ?: broken(destination)
        target.copied?.let { copied[it] = target.address }
        return relative(target)
    }

    private fun targetOf(destination: String): SitePlan.Target {
        val linked = resolve(path.substringBeforeLast('/', ""), destination.substringBefore('#'))
        return plan.target(linked).also { if (it is SitePlan.Target.Nowhere) broken(destination) }
    }

    private fun broken(destination: String): Nothing = error("$path links to “$destination”, which does not exist; correct the link.")

    private fun relative(target: SitePlan.Target.OnSite): String = relativeAddress(address, target.address)

    private fun unwrap(link: Node) {
        for (child in children(link)) link.insertBefore(child)
        link.unlink()
    }

    private companion object {
        val OUTSIDE = Regex("^[a-z]+:")
        val SOURCE = Regex("src=\"([^\"]*)\"")
    }
}

/** Returns the path of [link] in a file of [folder]; both are relative to the same root. */
internal fun resolve(folder: String, link: String): String {
    val parts = ArrayDeque(folder.split('/').filter { it.isNotEmpty() })
    for (part in link.split('/')) {
        when (part) {
            "", "." -> {}
            ".." -> check(parts.removeLastOrNull() != null) { "“$link” in “$folder” leads out of the repository." }
            else -> parts += part
        }
    }
    return parts.joinToString("/")
}

/** Returns the link from the page at [from] to the page at [to]. */
internal fun relativeAddress(from: String, to: String): String {
    val here = from.split('/').dropLast(1)
    val there = to.split('/')
    val common = here.zip(there.dropLast(1)).takeWhile { (a, b) -> a == b }.size
    return (List(here.size - common) { ".." } + there.drop(common)).joinToString("/")
}
