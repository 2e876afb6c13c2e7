package badlog.release

import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import java.io.File

/** The folder that `release` makes. */
internal val RELEASE = File(ROOT, "build/release")

/** The machine that builds, as downloads name it. */
internal val PLATFORM: String = System.getProperty("badlog.platform")

/** The download [name]; a test of one that not every machine can make asks [ifMade] first. */
internal fun download(name: String): File = File(RELEASE, name).also { check(it.isFile) { "build/release has no $name." } }

/** For a test of the download [name], which not every machine can make. */
internal fun ifMade(name: String): EnabledOrReasonIf = {
    if (File(RELEASE, name).isFile) Enabled.enabled else Enabled.disabled("$name was not made here; the release said why")
}

/** For tests of what Linux runs. */
internal val IF_LINUX: EnabledOrReasonIf = {
    if (PLATFORM.startsWith("linux")) Enabled.enabled else Enabled.disabled("clean machines are made on Linux only")
}

/** Unpacks [archive] into [folder] with the programs that people use, and returns the only file or folder in it. */
internal fun unpacked(archive: File, folder: File): File {
    folder.mkdirs()
    val command = when {
        archive.name.endsWith(".tar.gz") -> listOf("tar", "-xzf", "$archive", "-C", "$folder")
        archive.name.endsWith(".deb") -> listOf("dpkg-deb", "-x", "$archive", "$folder")
        else -> listOf("unzip", "-q", "$archive", "-d", "$folder")
    }
    val ended = run(ProcessBuilder(command))
    check(ended.code == 0) { "${command.joinToString(" ")}: ${ended.text}" }
    return folder.listFiles().orEmpty().singleOrNull() ?: folder
}
