package badlog.files

import java.net.InetAddress
import java.net.UnknownHostException

/** The name of this computer in its network, as a part of names of files. The system is asked once, which takes a moment. */
public val computerName: String by lazy { fileNamePart(nameInNetwork()) }

/** Returns [name] as a part of names of files on any system: in lower case and without spaces. */
public fun fileNamePart(name: String): String = safeName(name).lowercase().replace(' ', '-')

private fun nameInNetwork(): String = try {
    InetAddress.getLocalHost().hostName.substringBefore('.')
} catch (_: UnknownHostException) {
    ""
}.ifBlank { System.getenv("COMPUTERNAME").orEmpty() }.ifBlank { "laptop" }
