package badlog.formats

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith

class LogFormatsSpec : FunSpec({
    test("the readable logs are listed with the endings of each kind") {
        READABLE_LOGS shouldStartWith "bags (.bag, .badbag), CSV files (.csv), WPILOGs (.wpilog), Driver Station logs (.dslog, .dsevents), "
        READABLE_LOGS shouldContain "and ${LOG_FORMATS.last { it.endings != listOf(".csv") }.title}s ("
    }

    test("each ending has its dot and is in lower case, and no two formats share one") {
        LOG_ENDINGS.filterNot { it.startsWith('.') && it == it.lowercase() } shouldBe emptyList()
        LOG_ENDINGS.shouldBeUnique()
    }
})
