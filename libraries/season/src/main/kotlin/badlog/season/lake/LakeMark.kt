package badlog.season.lake

import badlog.files.writeAtomically
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import java.nio.file.Files
import java.nio.file.Path

/**
 * The file that describes a lake.
 *
 * @property ignored the files that turned out not to be logs, so that they are not read again.
 */
@Serializable
internal class LakeMark(val format: String = FORMAT, val version: Int = LakeLayout.VERSION, val ignored: List<Ignored> = emptyList()) {
    /** A file that is not a log, in its state when it was read, with the reason. */
    @Serializable
    class Ignored(val path: String, val size: Long, val modified: Long, val message: String) {
        /** Returns whether [source] is this file, unchanged. */
        fun isOf(source: LogSource): Boolean = path == source.path && size == source.size && modified == source.modified
    }

    val text: String get() = JSON.encodeToString(this)

    /** Returns the mark after a run over [logs]; [ignored] holds the files that are not logs, with the reasons. */
    fun after(logs: List<LogSource>, ignored: Map<LogSource, String>): LakeMark {
        val here = logs.mapTo(HashSet()) { it.path }
        return LakeMark(
            ignored =
            this.ignored.filter { it.path !in here } + ignored.map { (log, why) -> Ignored(log.path, log.size, log.modified, why) },
        )
    }

    fun write(folder: Path) = writeAtomically(folder.resolve(LakeLayout.MARK)) { it.write(text.encodeToByteArray()) }

    companion object {
        private const val FORMAT = "badlog-lake"
        private val JSON = Json {
            ignoreUnknownKeys = true
            encodeDefaults = true
            prettyPrint = true
        }

        /**
         * Returns the mark of the lake [folder]; null if it is not a lake.
         *
         * @throws LakeException if another version of badlog wrote it, or it cannot be parsed.
         */
        fun of(folder: Path): LakeMark? {
            val file = folder.resolve(LakeLayout.MARK)
            return if (Files.isRegularFile(file)) of(Files.readString(file), "$folder") else null
        }

        /**
         * Returns the mark of the lake [folder] with the content [text].
         *
         * @throws LakeException if another version of badlog wrote it, or it cannot be parsed.
         */
        fun of(text: String, folder: String): LakeMark {
            val mark = try {
                JSON.decodeFromString<LakeMark>(text)
            } catch (_: SerializationException) {
                throw LakeException("$folder/${LakeLayout.MARK} is damaged; delete the folder $folder and make the lake again.")
            }
            if (mark.format != FORMAT) throw LakeException("$folder is not a lake of badlog; name another folder.")
            if (mark.version != LakeLayout.VERSION) {
                throw LakeException(
                    "$folder is a lake of version ${mark.version}, but this badlog reads version ${LakeLayout.VERSION}; make the lake again in another folder.",
                )
            }
            return mark
        }
    }
}

/** Returns the path by which a lake identifies the file at [path]. */
internal fun pathOf(path: Path): String = path.toAbsolutePath().normalize().toString()
