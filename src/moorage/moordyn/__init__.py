"""MoorDyn-C's Python module: `import moorage.moordyn as moordyn` where a script says `import moordyn`.

>>> import moorage.moordyn as moordyn
>>> system = moordyn.Create("lines.txt")                         # doctest: +SKIP
>>> moordyn.Init(system, x, v)                                   # doctest: +SKIP
>>> forces = moordyn.Step(system, x, v, 0.0, 0.1)                # doctest: +SKIP
>>> moordyn.Close(system)                                        # doctest: +SKIP

Names, order of arguments, results and error codes are those of MoorDyn-C 2.7; what differs is in docs/moordyn-api.md.
"""

# ruff: noqa: F401, F403
from moorage.moordyn import generator as Generator
from moorage.moordyn.bodies import (
    GetBodyAngle,
    GetBodyAngVel,
    GetBodyForce,
    GetBodyID,
    GetBodyM,
    GetBodyPos,
    GetBodyState,
    GetBodyType,
    GetBodyVel,
)
from moorage.moordyn.codes import *
from moorage.moordyn.lines import (
    GetLineConstantEA,
    GetLineFairTen,
    GetLineID,
    GetLineMaxTen,
    GetLineN,
    GetLineNodeBendStiff,
    GetLineNodeCurv,
    GetLineNodeDrag,
    GetLineNodeForce,
    GetLineNodeFroudeKrilov,
    GetLineNodeM,
    GetLineNodePos,
    GetLineNodeSeabedForce,
    GetLineNodeTen,
    GetLineNodeVel,
    GetLineNodeWeight,
    GetLineNumberNodes,
    GetLineUnstretchedLength,
    IsLineConstantEA,
    IsLinePressBend,
    SetLineConstantEA,
    SetLinePressBend,
    SetLinePressInt,
    SetLineUnstretchedLength,
    SetLineUnstretchedLengthVel,
)
from moorage.moordyn.main import (
    BreakLine,
    Close,
    Create,
    GetBody,
    GetCFL,
    GetDt,
    GetFASTtens,
    GetLine,
    GetNumberBodies,
    GetNumberLines,
    GetNumberPoints,
    GetNumberRods,
    GetPoint,
    GetRod,
    GetTimeScheme,
    Init,
    Init_NoIC,
    Log,
    NCoupledDOF,
    SetCFL,
    SetDt,
    SetLogFile,
    SetLogLevel,
    SetTimeScheme,
    SetVerbosity,
    Step,
)
from moorage.moordyn.points import (
    GetPointAttached,
    GetPointForce,
    GetPointID,
    GetPointM,
    GetPointNAttached,
    GetPointPos,
    GetPointType,
    GetPointVel,
)
from moorage.moordyn.rods import (
    GetRodForce,
    GetRodID,
    GetRodM,
    GetRodN,
    GetRodNodePos,
    GetRodNodeVel,
    GetRodNumberNodes,
    GetRodType,
)
from moorage.moordyn.states import Deserialize, Load, LoadState, Save, SaveState, Serialize
from moorage.moordyn.vtk import SaveBodyVTK, SaveLineVTK, SavePointVTK, SaveRodVTK, SaveVTK, UseBodyVTK
from moorage.moordyn.water import (
    ExternalWaveKinGetCoordinates,
    ExternalWaveKinGetN,
    ExternalWaveKinInit,
    ExternalWaveKinSet,
    GetAverageDepth,
    GetDepthAt,
    GetMinDepth,
    GetSeafloor,
    GetWaveKinCoordinates,
    GetWaves,
    GetWavesKin,
    SetWaveKin,
)
