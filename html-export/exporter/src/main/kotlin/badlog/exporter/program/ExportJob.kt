package badlog.exporter.program

import java.nio.file.Path

/**
 * One page to make.
 *
 * @property input the file to read.
 * @property page the file to write; neither another job's page nor any job's input.
 * @property isFound whether [input] was found in a folder; such a file is not necessarily a log.
 */
internal class ExportJob(val input: Path, val page: Path, val isFound: Boolean)
