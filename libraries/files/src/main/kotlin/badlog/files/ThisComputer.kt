package badlog.files

import java.io.IOException
import java.net.InetAddress
import java.net.UnknownHostException
import java.nio.file.FileAlreadyExistsException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.util.UUID

/**
 * The name of this computer as a part of file names, such as `pit-3f2a`. It consists of the name in the network, and an id that
 * distinguishes it from other computers of that name. The system is asked once, which takes a moment.
 */
public val computerName: String by lazy {
    listOfNotNull(fileNamePart(nameInNetwork()), computerId(UserFolders.ofSystem().settings)).joinToString("-")
}

/** Returns [name] as a part of file names on any system: in lower case and without spaces. */
public fun fileNamePart(name: String): String = safeName(name).lowercase().replace(' ', '-')

private fun nameInNetwork(): String = try {
    InetAddress.getLocalHost().hostName.substringBefore('.')
} catch (_: UnknownHostException) {
    ""
}.ifBlank { System.getenv("COMPUTERNAME").orEmpty() }.ifBlank { "laptop" }

/** Returns the id of this computer, which the folder [settings] keeps. Null if it can neither be read nor written there. */
internal fun computerId(settings: Path): String? {
    val file = settings.resolve("computer-id")
    return try {
        Files.createDirectories(settings)
        try {
            Files.writeString(file, UUID.randomUUID().toString().take(ID_LENGTH), StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)
        } catch (_: FileAlreadyExistsException) {
            // It keeps its first one.
        }
        Files.readString(file).trim().takeIf(ID::matches)
    } catch (_: IOException) {
        null
    }
}

private const val ID_LENGTH = 4
private val ID = Regex("[0-9a-z]{1,16}")
