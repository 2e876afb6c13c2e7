package badlog.page

import java.net.BindException
import java.net.ServerSocket
import kotlin.random.Random

/** Returns a free port outside the range from which systems assign ports. So it is still free when a server takes it later. */
internal fun freePort(): Int = generateSequence { Random.nextInt(20_000, 32_000) }.first(::isFree)

private fun isFree(port: Int): Boolean = try {
    ServerSocket(port).close()
    true
} catch (_: BindException) {
    false
}
