package badlog.fetch

import badlog.files.UnwritableFileException
import badlog.files.reading
import badlog.files.writeAtomically
import java.nio.file.Path
import java.util.concurrent.CopyOnWriteArrayList
import kotlin.io.path.exists
import kotlin.io.path.readLines

/**
 * The host keys that a person trusted, stored in [file] in the format of OpenSSH's `known_hosts`.
 *
 * A key trusted at one address is trusted at all others, because only that robot has it; so there is no second question over USB. Several
 * keys may be trusted at one address, because the robots of a team share it.
 *
 * @param whenNotStored called, on any thread, if a key cannot be stored. If it returns, the key is trusted until the program ends.
 */
class KnownHosts(private val file: Path, private val whenNotStored: (UnwritableFileException) -> Unit = { throw it }) {
    private class Line(val host: String, val key: String)

    /** The lines that could not be written to [file]. */
    private val notStored = CopyOnWriteArrayList<String>()

    /** Returns whether the robot with [key] is known. */
    internal fun knows(key: String): Boolean = lines().any { it.key == key }

    /** Returns whether any key is known for [address]. */
    internal fun hasOther(address: RobotAddress): Boolean = lines().any { it.host == hostOf(address) }

    /**
     * Trusts [key] at [address] from now on.
     *
     * @throws UnwritableFileException if it cannot be stored, unless [whenNotStored] returns.
     */
    internal fun trust(address: RobotAddress, key: String) {
        val line = "${hostOf(address)} $key"
        val all = texts() + line
        try {
            writeAtomically(file) { out -> out.write(all.joinToString("") { it + "\n" }.encodeToByteArray()) }
        } catch (e: UnwritableFileException) {
            whenNotStored(e)
            notStored += line
        }
    }

    private fun texts() = (if (file.exists()) reading(file) { file.readLines() } else emptyList()) + notStored

    private fun lines() = texts().mapNotNull { text ->
        val words = text.trim().split(' ', limit = 2)
        if (words.size == 2 && !text.startsWith("#")) Line(words[0], words[1].split(' ').take(2).joinToString(" ")) else null
    }

    private fun hostOf(address: RobotAddress) = if (address.port == DEFAULT_PORT) address.host else "[${address.host}]:${address.port}"
}

private const val DEFAULT_PORT = 22
