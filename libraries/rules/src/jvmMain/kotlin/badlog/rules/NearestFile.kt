package badlog.rules

import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path

/**
 * A file about logs, in their folder or in one above.
 *
 * @property file the file; null if there is none.
 * @property found its content; null if there is none, or it has a mistake.
 * @property problem its problem and the remedy, as a sentence, with the line of the mistake below it if there is one; null if all is well.
 */
class NearestFile<T> internal constructor(val file: Path?, val found: T?, val problem: String?) {
    companion object {
        /**
         * Returns the nearest file for [log]. [inFolder] returns the file in a folder, or null if it has none. It is called for the log's own folder,
         * then for those above it up to [top]; only for the log's own folder if [top] is null, or not above it.
         *
         * @param parse parses the text of the file; throws an [IllegalArgumentException] with a message about its mistake.
         */
        fun <T> of(log: Path, top: Path?, inFolder: (Path) -> Path?, parse: (String) -> T): NearestFile<T> {
            val file = foldersOf(log, top).firstNotNullOfOrNull(inFolder) ?: return NearestFile(null, null, null)
            val problem = try {
                if (Files.size(file) <= MAX_BYTES) return NearestFile(file, parse(Files.readString(file)), null)
                "It is larger than 1 MB; remove what does not belong there."
            } catch (e: IllegalArgumentException) {
                e.message
            } catch (_: CharacterCodingException) {
                "It is not UTF-8 text; save it as UTF-8 in your editor."
            } catch (_: IOException) {
                "It cannot be read; check its permissions."
            }
            return NearestFile(file, null, problem)
        }

        /** Returns the folder of [log], and those above it up to [top]. Only its own if [top] is null, or not above it. */
        internal fun foldersOf(log: Path, top: Path?): Sequence<Path> {
            val own = log.toAbsolutePath().normalize().parent ?: return emptySequence()
            val last = top?.toAbsolutePath()?.normalize()
            if (last == null || !own.startsWith(last)) return sequenceOf(own)
            return generateSequence(own) { if (it == last) null else it.parent }
        }

        private const val MAX_BYTES = 1L shl 20
    }
}
