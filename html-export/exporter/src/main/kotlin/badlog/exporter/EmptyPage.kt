package badlog.exporter

import badlog.files.AtomicFile
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import java.nio.file.Files
import java.nio.file.Path

/**
 * A page without a log, which opens logs in any browser without installation. It runs the built-in rules, and contains a sample.
 *
 * @param parts the program and the styles of the page.
 */
class EmptyPage(private val parts: PageParts = PageParts.bundled()) {
    /**
     * Writes the page to [output]; creates its folder if necessary.
     *
     * @param network the servers to which the page may send requests.
     * @throws ExportException if it cannot be written.
     */
    fun write(output: Path, network: PageNetwork = PageNetwork.NONE) {
        val page = output.toAbsolutePath().normalize()
        checkWritable(page, emptyList())
        writing(page) {
            Files.createDirectories(page.parent)
            AtomicFile(page).use { file ->
                val writer = PageWriter(file.out, parts)
                writer.begin("badlog", network = network)
                writer.program(PageAdditions(rules = RuleSet.BUILT_IN))
                ExportThreads().use { threads ->
                    val sample = checkNotNull(EmptyPage::class.java.getResourceAsStream("/badlog/page/$SAMPLE")) {
                        "$SAMPLE is missing in this build of badlog."
                    }
                    sample.use { writer.sample(SAMPLE) { out -> RawEmbedding(threads, out).embed(it) } }
                }
                writer.end(network)
                file.commit()
            }
        }
    }

    companion object {
        /** The usual name of the page. */
        const val NAME: String = "badlog.html"

        /** The usual name of the page for a web server on a robot. As `index.html`, it would hide the list of logs that it requests. */
        const val SERVED_NAME: String = "logs.html"

        /** The usual name of the page for a web site. */
        const val WEB_NAME: String = "index.html"

        private const val SAMPLE = "brownout.bag"
    }
}
