package badlog.viewer.text

import badlog.signals.match.dateInText
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll

class DateTextSpec : FunSpec({
    test("a date is written for people, and in ISO 8601") {
        dateText(1_710_585_660) shouldBe "16 Mar 2024, 10:41"
        isoText(1_710_585_660) shouldBe "2024-03-16T10:41"
        dateText(0) shouldBe "1 Jan 1970, 00:00"
        isoText(-1) shouldBe "1969-12-31T23:59"
        isoText(951_782_400) shouldBe "2000-02-29T00:00"
    }

    test("a written date is read back as the same minute") {
        checkAll(Arb.long(946_684_800L..7_258_118_399L)) { second -> dateInText(isoText(second)) shouldBe second - second.mod(60) }
    }
})
