package badlog.plot.board

import badlog.rules.NearestFile
import java.nio.file.Files
import java.nio.file.Path

/**
 * The layout that a team has put beside its logs, with which windows and pages begin.
 *
 * @property file the file; null for none.
 * @property text what the file says, which pages carry; null for none, or where it has a mistake.
 * @property layout the same, read.
 * @property problem why a file that lies there is not used, as a sentence; null when all is well.
 */
public class FolderLayout private constructor(
    public val file: Path?,
    public val text: String?,
    public val layout: BoardLayout?,
    public val problem: String?,
) {
    public companion object {
        /** No layout. */
        public val NONE: FolderLayout = FolderLayout(null, null, null, null)

        /** What the file for all matches is called. */
        public const val NAME: String = "default${BoardLayout.ENDING}"

        /**
         * The layout for [log]: that of the nearest file in its folder, or in one above it up to [top], which is null for its folder alone. A file for a
         * type of matches (`practice.badlog-layout.json`, `qualification.…`, `elimination.…`) comes before [NAME] in the same folder.
         *
         * @param matchType gives the type of the match that the log is of, as `Qualification`, null for unknown; asked only where there is such a file.
         */
        public fun of(log: Path, top: Path? = null, matchType: () -> String? = { null }): FolderLayout {
            val type by lazy { matchType()?.lowercase().orEmpty() }
            val nearest = NearestFile.of(log, top, { folder -> fileIn(folder) { type } }) { text -> text to boardLayoutOf(NAME, text) }
            val file = nearest.file ?: return NONE
            val problem = nearest.problem?.replace(NAME, "It")?.let { "The layout $file is not used: $it" }
            return FolderLayout(file, nearest.found?.first, nearest.found?.second, problem)
        }

        private fun fileIn(folder: Path, type: () -> String): Path? {
            val typed = TYPES.keys.map { it to folder.resolve(it + BoardLayout.ENDING) }.filter { Files.isRegularFile(it.second) }
            val own = typed.firstOrNull { (name, _) -> TYPES.getValue(name).any { type().startsWith(it) } }?.second
            return own ?: folder.resolve(NAME).takeIf(Files::isRegularFile)
        }

        /** How the types of matches begin for which there may be a file, as robots, fields and names of files write them. */
        private val TYPES = mapOf(
            "practice" to listOf("prac"),
            "qualification" to listOf("qual"),
            "elimination" to listOf("elim", "playoff", "quarter", "semi", "final"),
        )
    }
}
