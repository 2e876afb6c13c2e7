package badlog.release

import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import java.io.File

/** The folder made by `release`. */
internal val RELEASE = File(ROOT, "build/release")

/** The building machine's platform, as in the names of downloads. */
internal val PLATFORM: String = System.getProperty("badlog.platform")

/** Returns the download [name]. If some machines cannot make it, the test must check [ifMade] first. */
internal fun download(name: String): File = File(RELEASE, name).also { check(it.isFile) { "build/release has no $name." } }

/** Enables a test of the download [name] if this machine could make it. */
internal fun ifMade(name: String): EnabledOrReasonIf = {
    if (File(RELEASE, name).isFile) Enabled.enabled else Enabled.disabled("$name was not made here; the release said why")
}

/** Enables a test on Linux. */
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
