package badlog.html.cli

import java.nio.file.Path

/**
 * One page to make.
 *
 * @property input the file to read.
 * @property page the file to write; no other job's page, and no job's input.
 * @property isFound whether [input] was found in a folder, so that nobody is sure it is a log.
 */
internal class ExportJob(val input: Path, val page: Path, val isFound: Boolean)
