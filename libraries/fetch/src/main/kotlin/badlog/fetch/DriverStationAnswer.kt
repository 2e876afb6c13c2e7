package badlog.fetch

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonObject
import java.io.IOException
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse.BodyHandlers
import java.time.Duration

/**
 * Returns the address of the robot that is connected to the 2027 Driver Station on this computer, such as `10.10.14.2`.
 *
 * Null if there is no Driver Station, or no robot. The Driver Station also knows a robot over USB or Wi-Fi, where a team's number does not
 * suffice.
 *
 * @param patience the maximum time to wait for the answer.
 * @param port the port of the Driver Station.
 */
internal fun robotOfDriverStation(patience: Duration, port: Int = DRIVER_STATION_PORT): String? = try {
    val request = HttpRequest.newBuilder(URI("http://localhost:$port/ip")).timeout(patience).build()
    val response = HttpClient.newBuilder().connectTimeout(patience).build().send(request, BodyHandlers.ofInputStream())
    val text = response.body().use { it.readNBytes(MAX_ANSWER) }.decodeToString()
    if (response.statusCode() == OK) robotIn(text) else null
} catch (_: IOException) {
    null
}

private fun robotIn(answer: String): String? = try {
    val address = (Json.parseToJsonElement(answer).jsonObject["robotIP"] as? JsonPrimitive)?.content.orEmpty()
    // The Driver Station up to 2026 sends the four bytes as one number.
    val bytes = address.toLongOrNull()?.let { number -> List(BYTES) { number shr Byte.SIZE_BITS * (BYTES - 1 - it) and 0xFF } }
        ?: address.split('.').map { part -> part.toLongOrNull()?.takeIf { it in 0..0xFF } ?: -1 }
    bytes.takeIf { it.size == BYTES && -1L !in it && it.any { byte -> byte != 0L } }?.joinToString(".")
} catch (_: IllegalArgumentException) {
    // Another program has this port.
    null
}

private const val DRIVER_STATION_PORT = 6768
private const val OK = 200
private const val BYTES = 4
private const val MAX_ANSWER = 4096
