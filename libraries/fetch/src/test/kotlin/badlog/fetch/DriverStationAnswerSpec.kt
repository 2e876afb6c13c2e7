package badlog.fetch

import com.sun.net.httpserver.HttpServer
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.ServerSocket
import java.time.Duration

private val PATIENCE = Duration.ofSeconds(60)

/** Returns the address learned from a Driver Station that answers with [body]. */
private fun learned(body: String, status: Int = 200): String? {
    val server = HttpServer.create(InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0)
    server.createContext("/ip") { exchange ->
        val bytes = body.encodeToByteArray()
        exchange.sendResponseHeaders(status, bytes.size.toLong())
        exchange.responseBody.use { it.write(bytes) }
    }
    server.start()
    return try {
        robotOfDriverStation(PATIENCE, server.address.port)
    } finally {
        server.stop(0)
    }
}

class DriverStationAnswerSpec : FunSpec({
    test("the 2027 Driver Station's answer is read, with the address as a text or a number") {
        learned("""{"robotIP":"172.26.0.1","fmsControlled":false}""") shouldBe "172.26.0.1"
        learned("""{"robotIP":168431106}""") shouldBe "10.10.14.2"
    }

    test("an answer without a robot, or of another program, has no address") {
        for (answer in listOf("""{"robotIP":0}""", """{"robotIP":"0.0.0.0"}""", "{}", "[]", "", "<html>", """{"robotIP":{}}""", """{"robotIP":"10.1.2"}""", """{"robotIP":"evil.example"}""")) {
            learned(answer) shouldBe null
        }
        learned("""{"robotIP":"10.10.14.2"}""", status = 404) shouldBe null
    }

    test("without a Driver Station, the address is unknown") {
        val free = ServerSocket(0).use { it.localPort }
        robotOfDriverStation(PATIENCE, free) shouldBe null
    }

    test("the address is tried first, unless it belongs to another team's robot, or an address was typed") {
        RobotAddress.beside("1014", null) { "172.26.0.1" }.map { "$it" }.take(2) shouldContainExactly listOf("172.26.0.1", "10.10.14.2")
        RobotAddress.beside("1014", null) { "10.10.14.7" }.first().name shouldBe "10.10.14.7"
        for (other in listOf<String?>("10.2.54.2", "10.10.14.2", null)) {
            RobotAddress.beside("1014", null) { other }.map { "$it" } shouldBe RobotAddress.of("1014").map { "$it" }
        }
        RobotAddress.beside("robot.local", null) { error("nobody asks") }.single().name shouldBe "robot.local"
    }
})
