package badlog.html.cli

import java.nio.file.Path

/**
 * What the command line asks for.
 *
 * @property paths the inputs, and perhaps the output, in their order; at least one.
 * @property outFolder the folder for all pages, or null for beside their inputs.
 * @property attachments files to put into each page.
 * @property hasRules whether the pages look for anything.
 * @property field the field of all pages, a file as WPILib's dashboards read it; null for those beside the logs.
 * @property video a video of the match that the only page shows; null for none.
 * @property opensPage whether to show a page in the browser.
 */
internal class Arguments(
    val paths: List<Path>,
    val outFolder: Path?,
    val attachments: List<Path>,
    val hasRules: Boolean,
    val field: Path?,
    val video: Path?,
    val opensPage: Boolean,
)
