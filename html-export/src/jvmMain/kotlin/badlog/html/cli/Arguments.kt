package badlog.html.cli

import java.nio.file.Path

/**
 * What the command line asks for.
 *
 * @property paths the inputs, and perhaps the output, in their order; at least one.
 * @property outFolder the folder for all pages, or null for beside their inputs.
 * @property attachments files to put into each page.
 * @property hasRules whether the pages look for anything.
 * @property opensPage whether to show a page in the browser.
 */
internal class Arguments(
    val paths: List<Path>,
    val outFolder: Path?,
    val attachments: List<Path>,
    val hasRules: Boolean,
    val opensPage: Boolean,
)
