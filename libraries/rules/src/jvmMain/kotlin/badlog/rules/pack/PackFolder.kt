package badlog.rules.pack

import java.io.IOException
import java.nio.file.FileVisitResult
import java.nio.file.Files
import java.nio.file.LinkOption
import java.nio.file.Path
import java.nio.file.SimpleFileVisitor
import java.nio.file.attribute.BasicFileAttributes

/** The files of the folder [pack]. Links are not followed: a pack that has one is refused. */
internal class PackFolder(private val pack: Path) : PackFiles {
    override val names: List<String>

    init {
        val found = Found()
        Files.walkFileTree(pack, emptySet(), PackLimits.DEPTH, found)
        names = found.names.sorted()
    }

    override fun bytes(name: String): ByteArray = try {
        Files.newInputStream(pack.resolve(name), LinkOption.NOFOLLOW_LINKS).readWithin(pack, name)
    } catch (e: IOException) {
        throw PackException("“$name” in $pack cannot be read (${e.message}); check its permissions.")
    }

    override fun close() = Unit

    private inner class Found : SimpleFileVisitor<Path>() {
        val names = ArrayList<String>()
        private var bytes = 0L

        override fun preVisitDirectory(folder: Path, attributes: BasicFileAttributes): FileVisitResult {
            if (folder == pack) return FileVisitResult.CONTINUE
            requireNoLink(folder, attributes)
            return if (isHidden(nameOf(folder))) FileVisitResult.SKIP_SUBTREE else FileVisitResult.CONTINUE
        }

        override fun visitFile(file: Path, attributes: BasicFileAttributes): FileVisitResult {
            val name = nameOf(file)
            requireNoLink(file, attributes)
            if (isHidden(name)) return FileVisitResult.CONTINUE
            if (attributes.isDirectory) {
                throw PackException(
                    "“$name” in $pack is nested too deeply; slices lie in fires/RULE/ and silent/RULE/.",
                )
            }
            if (attributes.size() > PackLimits.FILE_BYTES) throw tooLarge(pack, name)
            bytes += attributes.size()
            names += name
            if (names.size > PackLimits.FILES) throw tooManyFiles(pack)
            if (bytes > PackLimits.ALL_BYTES) throw tooLargeTogether(pack)
            return FileVisitResult.CONTINUE
        }

        /** A junction of Windows is neither a file nor a link. */
        private fun requireNoLink(path: Path, attributes: BasicFileAttributes) {
            if (attributes.isSymbolicLink || attributes.isOther) {
                throw PackException("“${nameOf(path)}” in $pack is a link; copy into the pack what it leads to.")
            }
        }

        private fun nameOf(path: Path) = pack.relativize(path).joinToString("/")
    }
}
