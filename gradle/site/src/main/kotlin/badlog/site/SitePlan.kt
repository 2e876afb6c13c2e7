package badlog.site

import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.name
import kotlin.io.path.walk

/**
 * The files of the repository that become pages of the site, with their addresses.
 *
 * Paths are relative to [root] and addresses to the site's folder; both have `/` between their parts.
 */
internal class SitePlan(private val root: Path) {
    /** The Markdown files that become pages, by path. */
    val pages: Map<String, String> = run {
        val guides = (root.resolve("docs").walk().filter { it.name.endsWith(".md") }.map { pathOf(it) }).toList()
        (BESIDE_DOCS + guides).sorted().associateWith(::pageAddress)
    }

    /** The target of a link on a page. */
    sealed interface Target {
        /** The place on the site at [address]. [copied] is the file of the repository to be copied there, null for a page. */
        data class OnSite(val address: String, val copied: String?) : Target

        /** A folder or a file of the repository that has no place on the site. */
        data object InRepository : Target

        /** No target, because the link is broken. */
        data object Nowhere : Target
    }

    /** Returns the target of a link to [path], a path without `#…`. */
    fun target(path: String): Target {
        pages[path]?.let { return Target.OnSite(it, null) }
        val readme = pages["$path/README.md".removePrefix("/")]
        val file = root.resolve(path)
        return when {
            readme != null -> Target.OnSite(readme, null)
            file.isDirectory() -> Target.InRepository
            !file.exists() -> Target.Nowhere
            LOG.matches(path) -> Target.OnSite("samples/${pageName(file.name)}", null)
            file.isRegularFile() && isPicture(path) -> Target.OnSite(path.removePrefix("docs/"), path)
            else -> Target.OnSite("files/$path", path)
        }
    }

    private fun pathOf(file: Path): String = root.relativize(file).joinToString("/")

    internal companion object {
        /** The contents of the site: its sections and their pages, in the order in which they are listed. */
        const val CONTENTS = "docs/README.md"

        /** The front page of the site. */
        const val FRONT = "README.md"

        private val BESIDE_DOCS =
            listOf(FRONT, "CHANGELOG.md", "CONTRIBUTING.md", "core/conformance/README.md", "gradle/README.md", "samples/README.md")
        private val LOG = Regex("""samples/[^/]+\.(bag|bag\.gz|csv)""")

        private fun isPicture(path: String): Boolean = path.substringAfterLast('.') in setOf("png", "svg", "gif", "webp")

        /** Returns the name of the exported page of the log [name]. */
        fun pageName(name: String): String = "$name.html"

        private fun pageAddress(path: String): String = when {
            path == FRONT -> "index.html"
            path == CONTENTS -> "guides.html"
            path.endsWith("/README.md") -> path.removePrefix("docs/").removeSuffix("README.md") + "index.html"
            else -> path.removePrefix("docs/").removeSuffix(".md").lowercase() + ".html"
        }
    }
}
