package badlog.signals.match.files

import badlog.core.json.JsonReader
import badlog.core.json.quotedJson
import badlog.signals.json.JsonFields
import badlog.signals.json.UnreadableJsonException
import badlog.signals.json.jsonArray
import badlog.signals.json.jsonObject

/**
 * The statements of a `match.json` about the files of a match.
 *
 * @property files the statements about each.
 */
class MatchManifest(val files: List<StatedFile>) {
    /** Returns the text of the file. */
    fun text(): String = jsonObject(
        VERSION_KEY to "$VERSION",
        FILES_KEY to jsonArray(files) { file ->
            jsonObject(
                "name" to quotedJson(file.name),
                "role" to file.role?.let { quotedJson(it.role) },
                "seconds" to file.seconds?.let { "$it" },
                "error" to file.error?.let { "$it" },
            )
        },
    ) + "\n"

    companion object {
        /** The name of the file. */
        const val NAME: String = "match.json"
        private const val VERSION = 1
        private const val VERSION_KEY = "version"
        private const val FILES_KEY = "files"
        private const val MAX_SECONDS = 1e10

        /**
         * Returns whether [text], of a file with this name, is meant as a manifest, even if it has mistakes. Other programs have files
         * of this name, too.
         */
        fun isOne(text: String): Boolean {
            val keys = JsonReader.readObject(text.removePrefix(BYTE_ORDER_MARK))?.map { it.key }
            return listOf(VERSION_KEY, FILES_KEY).all { if (keys == null) "\"$it\"" in text else it in keys }
        }

        /**
         * Reads [text].
         *
         * @throws MatchManifestException if it is not a manifest, or names something outside its folder.
         */
        fun of(text: String): MatchManifest = try {
            val fields = JsonFields(JsonReader.readObject(text.removePrefix(BYTE_ORDER_MARK)))
            if (fields.number(VERSION_KEY) != VERSION) {
                throw MatchManifestException("$NAME is from a newer badlog; update badlog.")
            }
            val files = fields.list(FILES_KEY) { item -> statedFile(JsonFields(item.members)) }
            files.groupBy { it.name.lowercase() }.values.find { it.size > 1 }?.let { twice ->
                throw MatchManifestException("$NAME names ${twice[0].name} twice.")
            }
            MatchManifest(files)
        } catch (_: UnreadableJsonException) {
            throw MatchManifestException("$NAME cannot be read; it needs version 1 and a list files, each with its name.")
        }

        private fun statedFile(fields: JsonFields): StatedFile {
            val name = fields.string("name")
            if (!isNameInside(name)) {
                throw MatchManifestException(
                    "$NAME names “${name.take(MAX_SHOWN)}”, which is outside its folder or no file name on every system; " +
                        "name only files beside it.",
                )
            }
            val role = fields.optional("role")?.let { role ->
                FileRole.of(role) ?: throw MatchManifestException(
                    "$NAME gives $name the role “${role.take(MAX_SHOWN)}”; roles are ${FileRole.entries.joinToString { it.role }}.",
                )
            }
            return StatedFile(name, role, seconds("seconds", name, fields), seconds("error", name, fields)?.takeIf { it >= 0 })
        }

        private fun seconds(key: String, name: String, fields: JsonFields): Double? = fields.find(key)?.takeIf {
            it.json != "null"
        }?.let { value ->
            value.json.toDoubleOrNull()?.takeIf { it in -MAX_SECONDS..MAX_SECONDS }
                ?: throw MatchManifestException("$NAME gives $name a clock that is not a number of seconds.")
        }

        private const val MAX_SHOWN = 40

        /** As editors of Windows write it. */
        private const val BYTE_ORDER_MARK = "\uFEFF"
    }
}

/**
 * The statements of a manifest about a file.
 *
 * @property name its name in the folder of the manifest, with slashes.
 * @property role the program that wrote it; null if the content decides.
 * @property seconds the shift of its times to the clock of the robot's log, in s; null if it has to be found.
 * @property error the possible error of [seconds], in s; null if unknown.
 */
class StatedFile(val name: String, val role: FileRole?, val seconds: Double?, val error: Double? = null)

/** Thrown if a `match.json` cannot be used; [message] is a sentence. */
class MatchManifestException(override val message: String) : Exception(message)

/** Returns whether [name], with slashes, names a file below its folder on any system. */
fun isNameInside(name: String): Boolean =
    name.length in 1..MAX_NAME && name.none { it < ' ' || it == '\u007f' || it == '\\' || it == ':' } &&
        name.split('/').none { it.isEmpty() || it == "." || it == ".." }

private const val MAX_NAME = 500
