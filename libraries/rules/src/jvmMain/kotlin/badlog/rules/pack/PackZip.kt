package badlog.rules.pack

import badlog.rules.RulesFile
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.ZipEntry
import java.util.zip.ZipFile

/**
 * The files of the zip [pack], read in place. Nothing is unpacked, so no name can lead out of the pack. A zip with names that are meant to
 * do so, or with a file that grows too much, is refused all the same. If everything is in one folder, as when a folder was zipped, that
 * folder is the pack.
 */
internal class PackZip(private val pack: Path) : PackFiles {
    private val zip: ZipFile
    private val entries: Map<String, ZipEntry>

    override val names: List<String> get() = entries.keys.toList()

    init {
        if (Files.size(pack) > PackLimits.ALL_BYTES) throw tooLargeTogether(pack)
        zip = try {
            ZipFile(pack.toFile())
        } catch (_: IOException) {
            throw notAZip()
        } catch (_: IllegalArgumentException) {
            throw notAZip()
        }
        entries = try {
            entriesOf(zip)
        } catch (e: Throwable) {
            zip.close()
            throw e
        }
    }

    override fun bytes(name: String): ByteArray = try {
        zip.getInputStream(entries.getValue(name)).readWithin(pack, name)
    } catch (_: IOException) {
        throw PackException("“$name” in $pack is damaged; make the zip again.")
    }

    override fun close() = zip.close()

    private fun entriesOf(zip: ZipFile): Map<String, ZipEntry> {
        if (zip.size() > PackLimits.FILES) throw tooManyFiles(pack)
        val seen = HashSet<String>()
        val files = sortedMapOf<String, ZipEntry>()
        var bytes = 0L
        for (entry in zip.entries()) {
            requireInside(entry.name)
            // Windows and macOS would take both for the same file.
            if (!seen.add(entry.name.trimEnd('/').lowercase())) {
                throw PackException("$pack has two files called “${shown(entry.name)}”; make the zip again from the folder.")
            }
            if (entry.isDirectory || isHidden(entry.name)) continue
            requireSize(entry)
            bytes += entry.size
            if (bytes > PackLimits.ALL_BYTES) throw tooLargeTogether(pack)
            files[entry.name] = entry
        }
        return withoutOuterFolder(files)
    }

    private fun requireInside(name: String) {
        val parts = name.removeSuffix("/").split('/')
        val isOdd = name.any { it.isISOControl() || it == '\\' || it == ':' } || parts.any { it.isEmpty() || it == "." || it == ".." }
        if (isOdd) throw PackException("“${shown(name)}” in $pack is not the name of a file in a pack; make the zip again from the folder.")
        // The outer folder may be one more.
        if (parts.size > PackLimits.DEPTH + 1) {
            throw PackException("“${shown(name)}” in $pack is nested too deeply; slices lie in fires/RULE/ and silent/RULE/.")
        }
    }

    private fun requireSize(entry: ZipEntry) {
        if (entry.size > PackLimits.FILE_BYTES) throw tooLarge(pack, shown(entry.name))
        val grows = entry.size > PackLimits.RATIO_COUNTS_FROM && entry.size / PackLimits.RATIO > entry.compressedSize
        if (grows) {
            throw PackException(
                "“${shown(entry.name)}” in $pack grows more than ${PackLimits.RATIO} times when it is read, as no log does; leave it out.",
            )
        }
    }

    private fun withoutOuterFolder(files: Map<String, ZipEntry>): Map<String, ZipEntry> {
        val outer = files.keys.mapTo(HashSet()) { it.substringBefore('/') + "/" }.singleOrNull() ?: return files
        return if (outer + RulesFile.NAME in files) files.mapKeys { (name, _) -> name.removePrefix(outer) } else files
    }

    private fun notAZip() = PackException("$pack is not a zip that can be read; make it again from the folder of the pack.")

    private fun shown(name: String) = name.take(MAX_SHOWN)
}

private const val MAX_SHOWN = 100
