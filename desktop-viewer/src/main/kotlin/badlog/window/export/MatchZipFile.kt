package badlog.window.export

import badlog.catalog.match.FileForZip
import badlog.catalog.match.writeMatchZip
import badlog.files.writeAtomically
import badlog.signals.match.files.FileRole
import badlog.window.log.OpenRecording
import java.io.IOException
import java.nio.file.Path

/**
 * Writes the file of [recording] and the shown Driver Station's log of its match to [target], a ZIP that opens as one log.
 *
 * @return a sentence about it.
 * @throws IOException with a sentence for the user, if a file cannot be read or written.
 */
internal fun matchZipFile(recording: OpenRecording, target: Path): String {
    val station = checkNotNull(recording.station) { "No Driver Station's log is shown with ${recording.file}." }
    // The error of a fit by one moment, or by clocks, is a guess.
    val error = station.fit.run { error.takeIf { edges > 1 } }
    val files = listOf(
        FileForZip(recording.file, FileRole.ROBOT, 0.0, null),
        FileForZip(station.log.path, FileRole.STATION, station.fit.seconds, error),
    )
    writeAtomically(target) { writeMatchZip(files, it) }
    return "Wrote ${recording.file.fileName} and ${station.log.name} to $target, which opens as one log."
}
