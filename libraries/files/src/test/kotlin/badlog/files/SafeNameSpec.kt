package badlog.files

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.Codepoint
import io.kotest.property.arbitrary.arabic
import io.kotest.property.arbitrary.ascii
import io.kotest.property.arbitrary.merge
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import java.nio.file.Path

class SafeNameSpec : FunSpec({
    test("an ordinary name stays unchanged") {
        for (name in listOf("FRC_20260316_104107_MILLC_Q42.wpilog", "Größe 1.bag.gz", "試合.bag", "a-b+c,(2).csv")) safeName(name) shouldBe name
    }

    test("no name leads to another folder, is hidden, or is a device") {
        safeName("../x") shouldBe "_._x"
        safeName("/etc/passwd") shouldBe "_etc_passwd"
        safeName("C:\\x") shouldBe "C__x"
        safeName("..") shouldBe "_"
        safeName("") shouldBe "_"
        safeName(".hidden") shouldBe "_hidden"
        safeName("a\u202Egab.bag") shouldBe "a_gab.bag"
        safeName("nul.csv") shouldBe "_nul.csv"
        safeName("end. ") shouldBe "end"
        safeName("x".repeat(300) + ".bag.gz") shouldBe "x".repeat(173) + ".bag.gz"
    }

    test("any name becomes one name in a folder, and making it safe again changes nothing") {
        checkAll(Arb.string(0, 300, Codepoint.ascii().merge(Codepoint.arabic()))) { name ->
            val safe = safeName(name)
            val folder = Path.of("/logs")
            folder.resolve(safe).normalize().parent shouldBe folder
            safe.none { it.isISOControl() || it in "/\\:*?\"<>|" } shouldBe true
            safeName(safe) shouldBe safe
        }
    }
})
