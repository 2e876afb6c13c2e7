package badlog.page.view

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class QuerySpec : FunSpec({
    test("every word has to occur, in any order") {
        Query("Left  drive").matches("drivetrain/left output") shouldBe true
        Query("left arm").matches("drivetrain/left output") shouldBe false
        Query("  ").isEmpty shouldBe true
    }
})
