package badlog.site

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.copyTo
import kotlin.io.path.copyToRecursively
import kotlin.io.path.createDirectories
import kotlin.io.path.createParentDirectories
import kotlin.io.path.deleteRecursively
import kotlin.io.path.exists
import kotlin.io.path.writeText

/**
 * The site of the guides in [root].
 *
 * @property parts finished parts, each by its folder on the site: the pages of the samples, a report, the API.
 */
internal class Site(private val root: Path, private val parts: Map<String, Path>) {
    /** Writes the site to [target], and removes all other files there. */
    @OptIn(ExperimentalPathApi::class)
    fun write(target: Path) {
        val plan = SitePlan(root)
        val reader = GuideReader(root, plan)
        val guides = plan.pages.keys.map(reader::read)
        val contents = contentsWithParts(Contents.of(guides.single { it.path == SitePlan.CONTENTS }))
        val frame = Frame(contents)
        val index = SearchIndex()
        target.deleteRecursively()
        target.createDirectories()
        for ((folder, part) in parts) part.copyToRecursively(target.resolve(folder).createParentDirectories(), followLinks = false)
        for (guide in guides) {
            target.resolve(guide.address).createParentDirectories().writeText(frame.page(guide))
            if (guide.path != SitePlan.CONTENTS) index.add(guide, contents.entry(guide.address)?.title ?: guide.title)
            for ((path, address) in guide.copied) {
                root.resolve(
                    path,
                ).copyTo(target.resolve(address).createParentDirectories(), overwrite = true)
            }
        }
        parts["api"]?.let { api -> ApiTypes.read(api).forEach { index.add("api/${it.address}", "API", it.name, it.full) } }
        target.resolve("search-index.js").writeText(index.script())
        for (asset in listOf("site.css", "site.js", "minisearch.js")) copyAsset(asset, target.resolve(asset))
    }

    /** Adds the parts that are not guides to the sections in which a reader looks for them. */
    private fun contentsWithParts(contents: Contents): Contents {
        val more = listOf(
            Triple("Try it", "open", Contents.Entry("Open your own logs", "open/index.html")),
            Triple("Try it", "samples", Contents.Entry("A match as a page", "samples/qualification-42.bag.html")),
            Triple("Try it", "report", Contents.Entry("A report on the samples", "report/index.html")),
            Triple("For developers", "api", Contents.Entry("API", "api/index.html")),
        ).filter { (_, folder, _) -> parts[folder]?.exists() == true }
        return Contents(
            contents.sections.map { section ->
                section.copy(entries = section.entries + more.filter { (title, _, _) -> title == section.title }.map { it.third })
            },
        )
    }

    private fun copyAsset(name: String, file: Path) {
        val asset =
            checkNotNull(Site::class.java.getResourceAsStream(name)) { "The site's program lacks its file “$name”; build it again." }
        asset.use { Files.copy(it, file) }
    }
}
