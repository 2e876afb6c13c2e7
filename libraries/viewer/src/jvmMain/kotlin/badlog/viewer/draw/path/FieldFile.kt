package badlog.viewer.draw.path

import badlog.rules.NearestFile
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path
import java.util.Base64

/**
 * The field that a team has put beside its logs, or selected.
 *
 * @property file the file; null if there is none.
 * @property json the field including its picture, which is embedded in pages; null if there is none, or if a file has a mistake.
 * @property field the same field, parsed, including its picture.
 * @property picture the bytes of the picture, PNG or JPEG; null if [json] is null.
 * @property problem the reason why a file is not used, as a sentence; null if it is used.
 */
class FieldFile private constructor(val file: Path?, val json: String?, val field: Field, val picture: ByteArray?, val problem: String?) {
    companion object {
        /** The result if there is no file. */
        val NONE: FieldFile = FieldFile(null, null, Field.PLAIN, null, null)

        /** The name of the file beside logs. */
        const val NAME: String = "field.json"

        /**
         * Returns the field for [log]. It is in the nearest file [NAME] in the log's folder, or in a folder above it up to [top]; if that
         * is null, only in its own folder.
         */
        fun of(log: Path, top: Path? = null): FieldFile {
            val nearest = NearestFile.of(log, top, { folder -> folder.resolve(NAME).takeIf(Files::isRegularFile) }, ::fieldOfJson)
            return of(nearest.file ?: return NONE, nearest.found, nearest.problem)
        }

        /** Returns the field in [file]. */
        fun read(file: Path): FieldFile = try {
            of(file, fieldOfJson(Files.readString(file)), null)
        } catch (e: FieldException) {
            of(file, null, e.message)
        } catch (_: CharacterCodingException) {
            of(file, null, "It is not in UTF-8; select the field’s .json file.")
        } catch (_: IOException) {
            of(file, null, "It cannot be read; check its name and its permissions.")
        }

        private fun of(file: Path, field: Field?, problem: String?): FieldFile {
            fun refused(why: String?) = FieldFile(file, null, Field.PLAIN, null, "The field $file is not used: $why")
            if (field == null) return refused(problem)
            val name = checkNotNull(field.image).source
            val bytes = try {
                val picture = file.resolveSibling(name)
                if (Files.size(picture) > MAX_BYTES) return refused("Its picture “$name” is larger than 3 MB; save it smaller.")
                Files.readAllBytes(picture)
            } catch (_: IOException) {
                return refused("Its picture “$name” cannot be read; put it beside the file.")
            } catch (_: InvalidPathException) {
                return refused("Its picture “$name” cannot be read; put it beside the file.")
            }
            val type =
                TYPES.entries.find { (_, begin) -> bytes.size > begin.size && begin.indices.all { bytes[it] == begin[it].toByte() } }?.key
                    ?: return refused("Its picture “$name” is neither PNG nor JPEG; save it as one of them.")
            val whole = field.withPicture("data:$type;base64," + Base64.getEncoder().encodeToString(bytes))
            return FieldFile(file, fieldJson(whole), whole, bytes, null)
        }

        private val TYPES = mapOf("image/png" to listOf(0x89, 0x50, 0x4E, 0x47), "image/jpeg" to listOf(0xFF, 0xD8, 0xFF))
        private const val MAX_BYTES = 3L shl 20
    }
}
