package badlog.exporter.program

import badlog.exporter.PageNetwork
import badlog.files.ResultPlace
import java.nio.file.Path

/**
 * The arguments of the command line.
 *
 * @property paths the inputs, and possibly the output, in order; empty only if there are [emptyPages].
 * @property out the folder for all pages, or the only page; null to put them beside their inputs.
 * @property attachments files to put into each page.
 * @property compared logs that each page draws over its own.
 * @property hasRules whether the pages run rules.
 * @property field the file with the field of all pages, in the format of WPILib's dashboards; null to use the files beside the logs.
 * @property video a video of the match for the only page; null if there is none.
 * @property emptyPages the pages without a log to make as well: the network of each, by the page's name.
 * @property opensPage whether to open a page in the browser.
 */
internal class Arguments(
    val paths: List<Path>,
    val out: ResultPlace?,
    val attachments: List<Path>,
    val compared: List<Path>,
    val hasRules: Boolean,
    val field: Path?,
    val video: Path?,
    val emptyPages: Map<String, PageNetwork>,
    val opensPage: Boolean,
) {
    /** Returns the path of the empty page called [name], a page without a log. */
    fun emptyPage(name: String): Path = (out?.takeIf { it.isFolder }?.path ?: Path.of("")).resolve(name).toAbsolutePath().normalize()
}
