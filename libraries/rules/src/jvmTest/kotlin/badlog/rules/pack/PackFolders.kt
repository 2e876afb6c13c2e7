package badlog.rules.pack

import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream

/** A rule for the file of rules of a pack. */
internal fun ruleText(name: String, condition: String = "A > 1", text: String = "t") = "[[rule]]\nname = \"$name\"\nseverity = \"warning\"\nwhen = \"$condition\"\ntext = \"$text\"\n"

/** The pack of [files], by their names, in this folder. */
internal fun Path.packFolder(name: String, vararg files: Pair<String, String>): Path = resolve(name).also { pack ->
    Files.createDirectories(pack)
    for ((file, content) in files) Files.writeString(pack.resolve(file).also { Files.createDirectories(it.parent) }, content)
}

/** The zip of [files] as they are, whatever their names. */
internal fun Path.packZip(name: String, vararg files: Pair<String, ByteArray>): Path = resolve(name).also { zip ->
    ZipOutputStream(Files.newOutputStream(zip)).use { out ->
        for ((file, content) in files) {
            out.putNextEntry(ZipEntry(file))
            out.write(content)
            out.closeEntry()
        }
    }
}

/** The folder [pack] zipped, with its own name before its files' names if [isOuter]. */
internal fun zipped(pack: Path, target: Path, isOuter: Boolean = false): Path {
    val files = Files.walk(pack).use { all -> all.filter(Files::isRegularFile).toList() }
    val before = if (isOuter) "${pack.fileName}/" else ""
    return target.parent.packZip(
        "${target.fileName}",
        *files.map { before + pack.relativize(it).joinToString("/") to Files.readAllBytes(it) }.toTypedArray(),
    )
}
