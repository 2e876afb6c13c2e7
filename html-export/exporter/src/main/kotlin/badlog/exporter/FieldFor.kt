package badlog.exporter

import badlog.viewer.draw.path.FieldFile
import java.nio.file.Path

/**
 * Returns the field on which a page of [log] draws paths: that of the file [selected], or else the one beside the log, see [FieldFile.of].
 */
fun fieldFor(log: Path, selected: Path? = null): FieldFile = selected?.let(FieldFile::read) ?: FieldFile.of(log)
