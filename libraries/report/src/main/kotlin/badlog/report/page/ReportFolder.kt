package badlog.report.page

import badlog.core.text.freeName
import badlog.exporter.ExportException
import badlog.exporter.HtmlExporter
import badlog.exporter.fieldFor
import badlog.exporter.layoutFor
import badlog.files.LogFile
import badlog.files.LogName
import badlog.files.UnwritableFileException
import badlog.files.requireTarget
import badlog.files.writeAtomically
import badlog.protocol.PageAdditions
import badlog.report.LogReport
import badlog.report.ReportResult
import badlog.report.hook.HookOutcome
import badlog.report.startOfBytes
import badlog.rules.RuleSet
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.nameWithoutExtension

/** Returns the sentence that refuses to replace [file], which badlog did not make. */
fun foreignFileSentence(file: Path): String = "$file exists already, and badlog did not make it; use --force to replace it, or $ELSEWHERE."

/** The advice, which fits a folder as well as a file. */
private const val ELSEWHERE = "name another place with --out"

/**
 * A folder with a report: `index.html`, and a page for each log that was added. Earlier pages of badlog are replaced, other files
 * are kept.
 *
 * @param logs the files that are read, and therefore never replaced.
 * @param rules the rules of the pages; use the report's, so that index and pages agree.
 * @param virtualTopics definitions of topics that the pages show in addition to the logs' own, if they can be calculated.
 * @param isForced whether to also replace files that badlog did not make.
 * @param field the file with the field that pages show below paths; null for the one beside each log, if any.
 * @param exporter makes the pages of the logs.
 */
class ReportFolder(
    private val folder: Path,
    logs: List<LogFile>,
    private val rules: RuleSet,
    private val virtualTopics: List<String> = emptyList(),
    private val isForced: Boolean = false,
    private val field: Path? = null,
    private val exporter: HtmlExporter = HtmlExporter(),
) {
    private val read = logs.mapTo(HashSet()) { realPath(it.path) }
    private val pages = HashMap<LogReport, String>()
    private val taken = hashSetOf(INDEX)
    private val index = folder.resolve(INDEX)
    private val problems = LinkedHashSet<String>()

    /** A sentence for each mistake in the layouts and fields beside the logs that have pages. */
    val problemsBeside: Set<String> get() = problems

    /**
     * Checks that the index can be written, so that an error comes before the work.
     *
     * @throws ExportException if another file is in its place.
     */
    fun checkIndex(): Unit = check(index)

    /**
     * Makes the page of [log], unless it cannot be read, with the rules and the outcomes of [hooks].
     *
     * @return its path; null if there is none.
     * @throws ExportException if the page cannot be made, or another file is in its place; other pages can still
     * be made.
     * @throws InterruptedException if the thread was interrupted.
     */
    fun add(log: LogReport, hooks: List<HookOutcome> = emptyList()): Path? {
        if (log.unreadable != null) return null
        val name = pageName(log)
        val page = folder.resolve(name)
        check(page)
        val defined = virtualTopics - log.undefined.mapTo(HashSet()) { it.definition }
        // A page only knows its own log.
        val compared = log.differences
        val layout = layoutFor(log.file.path, rules.signals)
        val ground = fieldFor(log.file.path, field)
        problems += listOfNotNull(layout.problem, ground.problem)
        val additions = PageAdditions(
            virtualTopics = defined,
            rules = rules,
            findings = compared.findings,
            hooks = hookParts(hooks),
            differences = compared.differences,
            layout = layout.text,
            field = ground.json,
        )
        exporter.export(log.file.path, page, additions)
        pages[log] = name
        return page
    }

    /**
     * Writes the index of [result], and the files of [charts], which it shows. Removes former files of charts that were not drawn.
     *
     * @param leaveOut receives the reason, as a sentence, for each chart that the index does not show because its files cannot be written.
     * @return its path.
     * @throws ExportException if it cannot be written, or another file is in its place.
     */
    fun writeIndex(
        result: ReportResult,
        title: String = "Report",
        charts: PageCharts = PageCharts.NONE,
        leaveOut: (String) -> Unit = {},
    ): Path {
        check(index)
        charts.undrawn.forEach(::removeFormer)
        val written = charts.all.filter { chart ->
            try {
                write(chart)
                true
            } catch (e: ExportException) {
                leaveOut(e.message.orEmpty())
                false
            }
        }
        val shown = PageCharts(written, charts.lacking)
        try {
            writeAtomically(index) { it.write(reportPage(result, title, shown) { log -> pages[log] }.encodeToByteArray()) }
        } catch (e: UnwritableFileException) {
            throw ExportException.Unwritable(index, e.message, e)
        }
        return index
    }

    private fun write(chart: PageChart) {
        val files = filesOf(chart)
        files.forEach { (file, _) -> check(file) }
        for ((file, bytes) in files) {
            try {
                writeAtomically(file) { it.write(bytes) }
            } catch (e: UnwritableFileException) {
                throw ExportException.Unwritable(file, e.message, e)
            }
        }
    }

    /** Removes former pictures of the chart [name]: beside the index, they would seem to be of these logs. */
    private fun removeFormer(name: String) {
        val place = folder.resolve(PageCharts.FOLDER)
        // The picture is known by the other file, which is therefore the last to go.
        val files = listOf("png", "svg").map { place.resolve("$name.$it") }
        try {
            for (file in files) if (Files.exists(file) && realPath(file) !in read && isOfBadlog(file)) Files.delete(file)
        } catch (_: IOException) {
            // The index does not show it.
        }
    }

    private fun filesOf(chart: PageChart): List<Pair<Path, ByteArray>> {
        val place = folder.resolve(PageCharts.FOLDER)
        return listOf(
            // The mark shows the next run that both are badlog's.
            place.resolve("${chart.name}.svg") to "$CHART_MARK${chart.svg}".encodeToByteArray(),
            place.resolve("${chart.name}.png") to chart.png,
        )
    }

    private fun check(page: Path) {
        try {
            requireTarget(page, ELSEWHERE) { realPath(it) in read }
        } catch (e: UnwritableFileException) {
            throw ExportException.Unwritable(page, e.message, e)
        }
        if (isForced || !Files.exists(page) || isOfBadlog(page)) return
        throw ExportException.Unwritable(page, foreignFileSentence(page))
    }

    private fun pageName(log: LogReport): String {
        val base = startOfBytes(LogName.of(log.file.name).stem, MAX_BYTES)
        return freeName(base, ".html") { taken.add(it.lowercase()) }
    }

    private companion object {
        const val INDEX = "index.html"
        const val HEAD = 16_384

        /** File systems allow 255, and a page has a longer name while it is being written. */
        const val MAX_BYTES = 180

        fun realPath(file: Path): Path = try {
            file.toRealPath()
        } catch (_: IOException) {
            file.toAbsolutePath().normalize()
        }

        const val CHART_MARK = "<!-- A chart that badlog made. -->\n"

        fun isOfBadlog(page: Path): Boolean = try {
            if (page.extension == "png") isOfBadlog(page.resolveSibling("${page.nameWithoutExtension}.svg")) else isMarked(page)
        } catch (_: IOException) {
            false
        }

        private fun isMarked(page: Path): Boolean {
            val head = Files.newInputStream(page).use { it.readNBytes(HEAD) }.decodeToString()
            return head.startsWith(CHART_MARK) || (head.startsWith("<!DOCTYPE html>") && GENERATOR in head)
        }
    }
}
