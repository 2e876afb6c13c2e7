package badlog.samples.generated

import badlog.samples.generated.fault.FAULTS
import badlog.samples.generated.fault.Naming
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec

@Tags("InProve")
class EveryNamingSpec : FunSpec({
    for (naming in Naming.entries) {
        test("logs of ${naming.id} without a fault are read without a problem, whatever looks like one") {
            for (i in 0..6) read(GENERATOR.healthy(naming, i * 3 + 2))
        }

        testFaults(naming, FAULTS)
    }
})
