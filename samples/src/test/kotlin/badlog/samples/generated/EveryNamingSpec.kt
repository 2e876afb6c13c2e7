package badlog.samples.generated

import badlog.samples.generated.fault.FAULTS
import badlog.samples.generated.fault.Naming
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec

@Tags("InProve")
class EveryNamingSpec : FunSpec({
    for (naming in Naming.entries) testFaults(naming, FAULTS)
})
