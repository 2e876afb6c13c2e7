package badlog.exporter

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.security.MessageDigest
import java.util.Base64

class PagePartsSpec : FunSpec({
    fun hash(text: String): String {
        val digest = MessageDigest.getInstance("SHA-256").digest(text.encodeToByteArray())
        return "'sha256-${Base64.getEncoder().encodeToString(digest)}'"
    }

    test("the policy has the hashes of the program and of both styles, as a browser reads their lines") {
        val parts = PageParts("let a\r\nlet ü\r", "b{}\r\n", "p{}\n")
        parts.policy(false) shouldContain "script-src ${hash(UNPACKING)} ${hash("let a\nlet ü\n")};"
        parts.policy(false) shouldContain "style-src ${hash("p{}\n")} ${hash("b{}\n")};"
        parts.policy(false).substringBefore(';') shouldBe "default-src 'none'"
    }

    test("only the page that has a video beside it may play one that the reader has not opened") {
        val parts = PageParts("", "")
        parts.policy(false) shouldContain "; media-src blob:;"
        parts.policy(true) shouldContain "; media-src blob: 'self';"
    }

    test("a style that would end its element is refused, a program and its style stand in the page packed") {
        val style = "a::after{content:'</Style>'}"
        PageParts("a='</script><!--'", style).packedProgram.decodeToString() shouldNotContain "<"
        shouldThrow<IllegalArgumentException> { PageParts("", "", style) }
    }

    test("a style that would end where the program begins is refused") {
        shouldThrow<IllegalArgumentException> { PageParts("", "a{}\u0000b{}") }
    }

    test("the page of this build is fit to be embedded") { PageParts.bundled().waitingStyle shouldContain ".waiting{" }
})
