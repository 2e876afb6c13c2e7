package badlog.season.lake

import badlog.file.LogFile
import badlog.file.writeAtomically
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import java.nio.file.Files
import java.nio.file.Path

/**
 * The file that says what a lake is.
 *
 * @property ignored the files that turned out to be no logs, so that they are not read again.
 */
@Serializable
internal class LakeMark(val format: String = FORMAT, val version: Int = LakeLayout.VERSION, val ignored: List<Ignored> = emptyList()) {
    /** A file that is no log, as it was then, and why. */
    @Serializable
    class Ignored(val path: String, val size: Long, val modified: Long, val message: String) {
        /** Whether [file] is it, unchanged. */
        fun isOf(file: LogFile): Boolean = path == pathOf(file) && size == file.size && modified == file.modified
    }

    /** Writes it into [folder]. */
    fun write(folder: Path) = writeAtomically(folder.resolve(LakeLayout.MARK)) { it.write(JSON.encodeToString(this).encodeToByteArray()) }

    companion object {
        private const val FORMAT = "badlog-lake"
        private val JSON = Json {
            ignoreUnknownKeys = true
            encodeDefaults = true
            prettyPrint = true
        }

        /**
         * That of the lake [folder]; null where it is none.
         *
         * @throws LakeException when another version of badlog wrote it, or it cannot be understood.
         */
        fun of(folder: Path): LakeMark? {
            val file = folder.resolve(LakeLayout.MARK)
            if (!Files.isRegularFile(file)) return null
            val mark = try {
                JSON.decodeFromString<LakeMark>(Files.readString(file))
            } catch (_: SerializationException) {
                throw LakeException("$file is damaged; delete the folder $folder and make the lake again.")
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

/** What a lake knows [file] by. */
internal fun pathOf(file: LogFile): String = pathOf(file.path)

/** What a lake knows the file at [path] by. */
internal fun pathOf(path: Path): String = path.toAbsolutePath().normalize().toString()
