package badlog.exporter

import badlog.viewer.draw.path.FieldFile
import java.nio.file.Path

/**
 * Returns the field on which a page of [log] draws paths. It is read from the file [selected], otherwise from the file beside the log, see
 * [FieldFile.of].
 */
fun fieldFor(log: Path, selected: Path? = null): FieldFile = selected?.let(FieldFile::read) ?: FieldFile.of(log)
