package badlog.plot.search

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class QuerySpec : FunSpec({
    test("every word has to occur, in any order, in capitals or not") {
        Query("Left  drive").matches("Drivetrain/LEFT Output") shouldBe true
        Query("left arm").matches("drivetrain/left output") shouldBe false
        Query("  ").isEmpty shouldBe true
        Query("\t").matches("") shouldBe true
        Query("Left").matchesLowercase("left") shouldBe true
    }
})
