package badlog.web

import badlog.core.waiting.eventually
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.inspectors.forAll
import io.kotest.matchers.collections.shouldBeIn
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.maps.shouldNotContainKey
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.io.File
import java.io.IOException
import java.net.URLEncoder
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.writeText

private const val SECRET = "secret of the robot"

@Tags("InCheck")
class HostileRequestSpec : FunSpec({
    /**
     * Starts a server with one log, and with secrets beside its folder. Secrets are also in hidden files, behind links, and under other
     * names.
     */
    fun withSecrets(test: (TestServer) -> Unit) = withServer { server ->
        val logs = server.logs
        logs.resolve("match.bag").writeText("log")
        logs.resolve("day 2").createDirectories().resolve("pit.bag").writeText("pit")
        logs.resolveSibling("secret.bag").writeText(SECRET)
        logs.resolve(".hidden.bag").writeText(SECRET)
        logs.resolve(".git").createDirectories().resolve("a.bag").writeText(SECRET)
        logs.resolve("passwords.txt").writeText(SECRET)
        logs.resolve("index.html").writeText(SECRET)
        if (File.separatorChar == '/') {
            logs.resolve("link.bag").createSymbolicLinkPointingTo(logs.resolveSibling("secret.bag"))
            logs.resolve("out").createSymbolicLinkPointingTo(logs.parent)
        }
        test(server)
    }

    test("files that are not in log folders, hidden, behind a link, or without a log's ending are never served") {
        withSecrets { server ->
            val above = server.logs.parent
            val attempts = listOf(
                "/../secret.bag", "/logs/../secret.bag", "/logs/../../secret.bag", "/logs/./match.bag", "/logs/day 2/../../secret.bag",
                "/%2e%2e/secret.bag", "/logs/%2e%2e/secret.bag", "/logs/%2E%2E%2Fsecret.bag", "/logs/..%2fsecret.bag", "/logs/..%5csecret.bag",
                "/logs/%252e%252e/secret.bag", "/logs/%c0%ae%c0%ae/secret.bag", "/logs/..%00/secret.bag", "/logs/match.bag%00.txt",
                "/logs//match.bag", "//match.bag", "/logs/day%202//pit.bag", "/logs/%2fetc%2fpasswd", "/etc/passwd", "$above/secret.bag",
                "/logs/%2F${above.toString().drop(1)}/secret.bag", "/logs/.hidden.bag", "/logs/%2ehidden.bag", "/logs/.git/a.bag", "/logs/.git/",
                "/logs/.git/?format=json", "/logs/passwords.txt", "/logs/index.html", "/logs/link.bag", "/logs/out/secret.bag",
                "/logs/out/?format=json", "/logs/out/logs/match.bag", "/logs/C:%5csecret.bag", "/logs/match.bag:stream", "/logs/match.bag/",
                "/logs/match.bag/x.bag", "/logs/day%202", "/logs", "/logs/", "/logs/%ff.bag", "/logs/%zz.bag", "/logs/match.bag;a=b", "/badlog/web/logs.html.gz",
                "/logs/" + "../".repeat(3000) + "secret.bag", "/logs/" + "a/".repeat(3000) + "x.bag",
            )
            for (attempt in attempts) {
                withClue(attempt.take(80)) {
                    val answer = server.sent("GET $attempt HTTP/1.1\r\nHost: localhost\r\n\r\n")
                    if (answer != null) {
                        answer.status shouldBeIn listOf(400, 404)
                        answer.text shouldNotContain SECRET
                    }
                }
            }
            server.get("/logs/match.bag").text shouldBe "log"
            server.get("/logs/day%202/pit.bag").text shouldBe "pit"
            server.get("/logs/?format=json").text.let { listing ->
                for (name in listOf("hidden", "git", "passwords", "index", "link", "out")) listing shouldNotContain name
            }
        }
    }

    test("another site that points its name here reads nothing (DNS rebinding)") {
        withSecrets { server ->
            val foreign = listOf(
                "evil.example", "evil.example:5806", "robot.local.evil.example", "10.10.14.2.evil.example", "roborio-1014-frc.evil.example", "roborio-evil.example",
                "localhost.evil.example", "xlocalhost", "", "10.10.14.2@evil.example", "10.10.14.2:5806:80", "[::1].evil.example", "10.10.14", "robot.local/",
            )
            for (host in foreign) {
                withClue(host) {
                    for (address in listOf("/", "/?format=json", "/logs/match.bag")) {
                        val answer = server.sent("GET $address HTTP/1.1\r\nHost: $host\r\n\r\n")
                        if (answer != null) answer.status shouldBeIn listOf(400, 421)
                    }
                }
            }
            server.sent("GET / HTTP/1.0\r\n\r\n")?.status shouldBe 421
            server.sent("GET / HTTP/1.1\r\nHost: localhost\r\nHost: evil.example\r\n\r\n")?.status shouldBe 421
            val own = listOf(
                "localhost", "LOCALHOST:1", "127.0.0.1:5806", "10.10.14.2", "[::1]:5806", "[fe80::1]", "robot.local:5806", "roboRIO-1014-FRC.local:5806",
                "roborio-254-frc", "roborio-9999-frc.lan", "roborio-1-frc.frc-field.local",
            )
            // A download frees its place only a moment after it has arrived.
            for (host in own) eventually("the log, for $host") { server.sent("GET /logs/match.bag HTTP/1.1\r\nHost: $host\r\n\r\n")?.status == 200 }
        }
    }

    test("other sites may neither read an answer nor frame the page") {
        withSecrets { server ->
            for (address in listOf("/", "/?format=json", "/logs/match.bag", "/nothing")) {
                val headers = server.get(address, "Origin: http://evil.example").headers
                headers.keys.filter { it.startsWith("access-control") } shouldBe emptyList()
                headers["cross-origin-resource-policy"] shouldBe "same-origin"
                headers["x-frame-options"] shouldBe "DENY"
                headers["x-content-type-options"] shouldBe "nosniff"
            }
        }
    }

    test("nothing but GET is answered, and nothing is changed") {
        withSecrets { server ->
            for (method in listOf("POST", "PUT", "DELETE", "PATCH", "OPTIONS", "HEAD", "TRACE", "PROPFIND", "get")) {
                withClue(method) {
                    val answer = checkNotNull(server.sent("$method /logs/match.bag HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n\r\n"))
                    answer.status shouldBe 405
                    answer.headers["allow"] shouldBe "GET"
                    answer.text shouldNotContain "log\n".repeat(2)
                }
            }
            server.get("/logs/match.bag").text shouldBe "log"
        }
    }

    test("anything but a request, or a huge one, ends its connection and nothing else") {
        withSecrets { server ->
            val attempts = listOf(
                "\r\n\r\n", "GET\r\n\r\n", "GET / HTTP/9.9\r\n\r\n", "\u0016\u0003\u0001\u0002\r\n\r\n", "GET http://evil.example/ HTTP/1.1\r\nHost: evil.example\r\n\r\n",
                "GET / HTTP/1.1\r\nHost: localhost\r\n" + "X: y\r\n".repeat(5000) + "\r\n",
                "GET / HTTP/1.1\r\nHost: localhost\r\nContent-Length: -1\r\n\r\n", "GET / HTTP/1.1\r\nHost: localhost\r\nContent-Length: x\r\n\r\n",
                "GET /?format=json HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\nffffffffffffffffffff\r\n",
            )
            for (attempt in attempts) {
                withClue(attempt.take(60)) {
                    try {
                        server.sent(attempt)?.let { it.text shouldNotContain SECRET }
                    } catch (_: IOException) {
                        // The connection was closed while it was still written to.
                    }
                }
            }
            server.get("/logs/match.bag").text shouldBe "log"
        }
    }

    test("names of files become neither markup nor the end of a text").config(enabledOrReasonIf = { IF_UNIX }) {
        withServer { server ->
            val names = listOf("<img src=x onerror=alert(1)>.bag", "a\"},{\"size.bag", "<!--<script>.bag", "line\u2028end.bag", "Mödül & 1 #?%.bag", "+ +.bag")
            for (name in names) server.logs.resolve(name).writeText(name)
            val listing = server.get("/logs/?format=json")
            listing.headers["content-type"] shouldBe "application/json"
            listing.text.all { it in ' '..'~' } shouldBe true
            for (part in listOf("<", ">", "&", "\\\"", "script\"")) listing.text shouldNotContain part
            listing.text shouldContain "\\u003cimg src=x onerror=alert(1)\\u003e.bag"
            for (name in names) {
                val address = URLEncoder.encode(name, "UTF-8").replace("+", "%20")
                server.get("/logs/$address").text shouldBe name
            }
        }
    }
})
