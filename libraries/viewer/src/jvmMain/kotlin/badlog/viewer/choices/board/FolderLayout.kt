package badlog.viewer.choices.board

import badlog.rules.NearestFile
import badlog.signals.match.MatchType
import java.io.IOException
import java.nio.file.DirectoryIteratorException
import java.nio.file.Files
import java.nio.file.Path

/**
 * The layout that a team has put beside its logs; windows and pages open with it.
 *
 * @property file the file; null if there is none.
 * @property text the content of the file, which is embedded in pages; null if there is none, or if it has a mistake.
 * @property layout the same content, parsed.
 * @property problem the reason why an existing file is not used, as a sentence; null if it is used.
 */
class FolderLayout private constructor(val file: Path?, val text: String?, val layout: BoardLayout?, val problem: String?) {
    companion object {
        val NONE: FolderLayout = FolderLayout(null, null, null, null)

        /** The name of the file for all matches. */
        const val NAME: String = "default${BoardLayout.ENDING}"

        /**
         * Returns the layout for [log]. It is in the nearest file in the log's folder, or in a folder above it up to [top]; if that is
         * null, only in its own folder. A file for a type of match (`practice.badlog-layout.json`, `qualification.…`, `elimination.…`)
         * comes before [NAME] in the same folder.
         *
         * @param matchType returns the type of the log's match, such as `Qualification`, or null if unknown; called only if there is such
         *   a file.
         */
        fun of(log: Path, top: Path? = null, matchType: () -> String? = { null }): FolderLayout {
            val type by lazy { matchType()?.let { MatchType.of(it) } }
            val nearest = NearestFile.of(log, top, { folder -> fileIn(folder) { type } }) { text -> text to boardLayoutOf(NAME, text) }
            val file = nearest.file ?: return NONE
            val problem = nearest.problem?.replace(NAME, "It")?.let { "The layout $file is not used: $it" }
            return FolderLayout(file, nearest.found?.first, nearest.found?.second, problem)
        }

        /**
         * Returns the layouts that a team keeps in [folder] under names of its own, such as `Power.badlog-layout.json`. They are sorted
         * by these names. The default layouts, with which logs begin, are not among them.
         *
         * @throws IOException with a sentence for the person, if the folder cannot be read.
         */
        fun keptIn(folder: Path): Map<String, Path> = try {
            Files.newDirectoryStream(folder, "*${BoardLayout.ENDING}").use { files ->
                inOrder(files.filter(Files::isRegularFile).mapNotNull { file -> nameOf(file)?.let { it to file } }.toMap())
            }
        } catch (e: IOException) {
            throw unreadable(folder, e)
        } catch (e: DirectoryIteratorException) {
            throw unreadable(folder, e)
        }

        /** Returns the name of the kept layout in [file]. Null if it is not a layout, or is a default one. */
        fun nameOf(file: Path): String? {
            val name = file.fileName.toString()
            return name.removeSuffix(BoardLayout.ENDING).takeIf { it != name && it !in TYPES && name != NAME }
        }

        /** Returns [layouts], sorted by their names. */
        fun inOrder(layouts: Map<String, Path>): Map<String, Path> = layouts.toSortedMap(BY_NAME)

        private fun unreadable(folder: Path, cause: Exception) =
            IOException("The layouts in $folder cannot be read; check that the folder is there and may be read.", cause)

        private val BY_NAME = compareBy<String> { it.lowercase() }.thenBy { it }

        private fun fileIn(folder: Path, type: () -> MatchType?): Path? {
            val typed = TYPES.keys.map { it to folder.resolve(it + BoardLayout.ENDING) }.filter { Files.isRegularFile(it.second) }
            val own = typed.firstOrNull { (name, _) -> type() in TYPES.getValue(name) }?.second
            return own ?: folder.resolve(NAME).takeIf(Files::isRegularFile)
        }

        /** The types of match that may have a file, by the name of the file. */
        private val TYPES = mapOf(
            "practice" to setOf(MatchType.PRACTICE),
            "qualification" to setOf(MatchType.QUALIFICATION),
            "elimination" to
                setOf(MatchType.ELIMINATION, MatchType.PLAYOFF, MatchType.QUARTERFINAL, MatchType.SEMIFINAL, MatchType.FINAL),
        )
    }
}
