package badlog.catalog.todo

import java.net.InetAddress
import java.net.UnknownHostException

/** Returns the name of this computer in its network; it may ask the system, which takes a moment. */
fun computerName(): String = try {
    InetAddress.getLocalHost().hostName.substringBefore('.')
} catch (_: UnknownHostException) {
    ""
}.ifBlank { System.getenv("COMPUTERNAME").orEmpty() }.ifBlank { "laptop" }
