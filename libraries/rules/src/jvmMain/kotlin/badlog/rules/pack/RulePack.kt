package badlog.rules.pack

import badlog.rules.BUILT_IN
import badlog.rules.DeviceNames
import badlog.rules.RuleSet
import badlog.rules.RulesException
import badlog.rules.RulesFile
import badlog.rules.SignalsFile
import badlog.rules.TomlText
import badlog.rules.cause.CauseGraph
import badlog.rules.causeGraphOf
import badlog.rules.notTooDeep
import badlog.signals.vocabulary.SignalVocabulary
import java.nio.charset.CharacterCodingException
import java.nio.file.Path

/**
 * A folder or zip with rules and slices. Slices are pieces of logs in which the rules must, or must not, find something. `docs/rules.md`
 * describes the format. A pack is only data: nothing in it is ever run. Close it after reading its slices.
 *
 * @property path the folder or zip.
 * @property rules its rules, with the built-in names of signals and its own.
 * @property slices its slices, in order of their names.
 * @property ignored the names of files that are not part of a pack.
 */
class RulePack private constructor(
    val path: Path,
    private val files: PackFiles,
    val rules: RuleSet,
    internal val signals: SignalVocabulary,
    internal val causes: CauseGraph,
) : AutoCloseable {
    /**
     * A piece of a log.
     *
     * @property name its name in the pack, such as `fires/Shooter jammed/q42.bag`.
     * @property isFiring whether the rule must find something in it; otherwise it must not.
     * @property folder the folder for the slices of its rule.
     */
    class Slice internal constructor(val name: String, val isFiring: Boolean, val folder: String)

    val slices: List<Slice> = files.names.mapNotNull(::sliceOf)

    val ignored: List<String> = files.names.filter { it !in DATA && !isNote(it) && sliceOf(it) == null }

    /** The built-in rules joined with the pack's, as they run over logs beside the pack. */
    val withBuiltIn: RuleSet get() = RuleSet.BUILT_IN.with(rules.signals).and(listOf(this))

    /**
     * Returns the bytes of [slice].
     *
     * @throws PackException if it cannot be read, or is compressed: its size would not show the memory that reading it takes.
     */
    fun bytesOf(slice: Slice): ByteArray = files.bytes(slice.name).also { bytes ->
        val isCompressed = COMPRESSED.any { it.size <= bytes.size && it.indices.all { i -> bytes[i] == it[i] } }
        if (isCompressed) throw PackException("“${slice.name}” in $path is compressed; put the log itself there.")
    }

    override fun close() = files.close()

    companion object {
        /** The ending of the name of a folder that is a pack. */
        const val ENDING: String = ".badlog-rules"

        /** The ending of the name of a zip that is a pack. */
        const val ZIP_ENDING: String = "$ENDING.zip"

        /** The folder of slices in which rules must find something. */
        const val FIRES: String = "fires"

        /** The folder of slices in which rules must not find anything. */
        const val SILENT: String = "silent"

        /** The keys allowed in a pack's file of rules. Hooks are programs, and a pack adds to the rules of others, so it turns none of them off. */
        private val KEYS = setOf("aliases", "rule", "cause", "leads_to")

        private val DATA = setOf(RulesFile.NAME, SignalsFile.NAME, DeviceMap.NAME)

        /** Returns whether the file [name] is a text for people. */
        private fun isNote(name: String) = '/' !in name && ('.' !in name || NOTE_ENDINGS.any { name.endsWith(it, ignoreCase = true) })

        private val NOTE_ENDINGS = listOf(".md", ".txt")

        /** The first bytes of files made by gzip or xz. */
        private val COMPRESSED = listOf(byteArrayOf(0x1F, 0x8B.toByte()), byteArrayOf(0xFD.toByte(), 0x37, 0x7A, 0x58, 0x5A))

        /**
         * Opens the pack at [path].
         *
         * @throws PackException if it is not one, or something in it is wrong.
         */
        fun open(path: Path): RulePack {
            val files = PackFiles.of(path)
            return try {
                read(path, files)
            } catch (e: Throwable) {
                files.close()
                throw e
            }
        }

        private fun read(path: Path, files: PackFiles): RulePack {
            if (RulesFile.NAME !in files.names) throw PackException("$path has no ${RulesFile.NAME}, so it is not a pack of rules.")
            val signals = textOf(path, files, SignalsFile.NAME)?.let { inFile(path, SignalsFile.NAME) { SignalsFile.parse(it) } }
                ?: SignalVocabulary.NONE
            val devices =
                textOf(path, files, DeviceMap.NAME)?.let { inFile(path, DeviceMap.NAME) { DeviceMap.parse(it) } } ?: DeviceNames.NONE
            val text = textOf(path, files, RulesFile.NAME).orEmpty()
            return inFile(path, RulesFile.NAME) {
                notTooDeep {
                    val toml = TomlText(text)
                    val causes = causeGraphOf(toml, toml.root(KEYS, "a pack's rules"))
                    val rules = RulesFile.parse(text, RuleSet.BUILT_IN.signals.with(signals)).rules.with(devices)
                    RulePack(path, files, rules, signals, causes)
                }
            }
        }

        private fun <T> inFile(pack: Path, name: String, read: () -> T): T = try {
            read()
        } catch (e: RulesException) {
            throw PackException("$name in $pack: ${e.message}")
        }

        private fun textOf(pack: Path, files: PackFiles, name: String): String? {
            if (name !in files.names) return null
            val bytes = files.bytes(name)
            if (bytes.size > MAX_TEXT) throw PackException("$name in $pack is larger than 1 MB; remove what does not belong there.")
            return try {
                bytes.decodeToString(throwOnInvalidSequence = true)
            } catch (_: CharacterCodingException) {
                throw PackException("$name in $pack is not UTF-8 text; save it as UTF-8 in your editor.")
            }
        }

        private const val MAX_TEXT = 1 shl 20

        private fun sliceOf(name: String): Slice? {
            val parts = name.split('/')
            if (parts.size != SLICE_PARTS || SLICE_ENDINGS.none { name.endsWith(it, ignoreCase = true) }) return null
            return when (parts[0].lowercase()) {
                FIRES -> Slice(name, isFiring = true, parts[1])
                SILENT -> Slice(name, isFiring = false, parts[1])
                else -> null
            }
        }

        private const val SLICE_PARTS = 3

        /** Logs that no other program unpacks, so that reading a slice takes no more memory than its size promises. */
        private val SLICE_ENDINGS = listOf(".bag", ".csv", ".wpilog")
    }
}
