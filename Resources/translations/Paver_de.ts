<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>App::Property</name>
    <message>
        <source>Target length of the element edges, e.g. 30, "30 mm", 1.5in. 0: not given</source>
        <translation>Ziellänge der Elementkanten, z. B. 30, „30 mm“, 1.5in. 0: nicht gegeben</translation>
    </message>
    <message>
        <source>Working frequency instead of size, e.g. 3GHz, "300 MHz", 9e9. 0: not given</source>
        <translation>Arbeitsfrequenz statt der Länge, z. B. 3GHz, „300 MHz“, 9e9. 0: nicht gegeben</translation>
    </message>
    <message>
        <source>Elements per wavelength [10]</source>
        <translation>Elemente je Wellenlänge [10]</translation>
    </message>
    <message>
        <source>Relative permittivity of the medium [1]</source>
        <translation>Relative Permittivität des Mediums [1]</translation>
    </message>
    <message>
        <source>Relative permeability of the medium [1]</source>
        <translation>Relative Permeabilität des Mediums [1]</translation>
    </message>
    <message>
        <source>Largest turn of the surface per element edge, degrees [45; 75 where that stays as close]. 0: not given</source>
        <translation>Größte Drehung der Fläche je Elementkante in Grad [45; 75, wo das gleich nahe bleibt]. 0: nicht gegeben</translation>
    </message>
    <message>
        <source>Across a ridge elements are at most so many times narrower than along it; 1: not narrower [8]</source>
        <translation>Quer zu einem Grat sind Elemente höchstens so vielmal schmaler als längs; 1: nicht schmaler [8]</translation>
    </message>
    <message>
        <source>Largest growth of the element size per unit of length [0.6]</source>
        <translation>Größtes Wachstum der Elementgröße je Längeneinheit [0.6]</translation>
    </message>
    <message>
        <source>Where the surface comes to a point the target length is divided by R; 1: not [32]</source>
        <translation>Wo die Oberfläche in eine Spitze ausläuft, wird die Ziellänge durch R geteilt; 1: nicht [32]</translation>
    </message>
    <message>
        <source>At sharp outer edges the target length is divided by R; 1: not [1]</source>
        <translation>An scharfen Außenkanten wird die Ziellänge durch R geteilt; 1: nicht [1]</translation>
    </message>
    <message>
        <source>Faces narrower than 0.7 target lengths: one element across; refine:K: shorter ones, about K across [one]</source>
        <translation>Flächen, die schmaler als 0,7 Ziellängen sind: ein Element quer; refine:K: kürzere, etwa K quer [one]</translation>
    </message>
    <message>
        <source>Largest distance between mesh and surface: what is farther off gets shorter lengths [as it comes]. 0: not given</source>
        <translation>Größter Abstand zwischen Netz und Oberfläche: was weiter abliegt, erhält kürzere Längen [wie er sich ergibt]. 0: nicht gegeben</translation>
    </message>
    <message>
        <source>Target length of a part where shorter: Face3=2mm, Edge5,Vertex2=0.5, Solid1=eps-r:4; may be repeated. Besides those of the refinements</source>
        <translation>Ziellänge eines Teils, wo sie kürzer ist: Face3=2mm, Edge5,Vertex2=0.5, Solid1=eps-r:4; mehrfach möglich. Neben denen der Verfeinerungen</translation>
    </message>
    <message>
        <source>Stop before meshing when more elements are predicted [2000000]</source>
        <translation>Vor dem Vernetzen anhalten, wenn mehr Elemente vorhergesagt sind [2000000]</translation>
    </message>
    <message>
        <source>What solids are made of: FR4=Solid1,eps-r:4.4,tan-d:0.02, Metal=Solid2,conductor; may be repeated. Besides those that are objects of their own</source>
        <translation>Woraus Volumenkörper bestehen: FR4=Solid1,eps-r:4.4,tan-d:0.02, Metal=Solid2,conductor; auch mehrfach. Neben denen, die eigene Objekte sind</translation>
    </message>
    <message>
        <source>Faces, edges, vertices that are a group of the mesh: Feed=Edge5; never merged with others; may be repeated. Besides those that are objects of their own</source>
        <translation>Flächen, Kanten, Punkte, die eine Gruppe des Netzes sind: Feed=Edge5; nie mit anderen verschmolzen; auch mehrfach. Neben denen, die eigene Objekte sind</translation>
    </message>
    <message>
        <source>Edges that stand for a thin wire: Mast=Edge5,radius:0.5mm; may be repeated. Besides those that are objects of their own</source>
        <translation>Kanten, die für einen dünnen Draht stehen: Mast=Edge5,radius:0.5mm; auch mehrfach. Neben denen, die eigene Objekte sind</translation>
    </message>
    <message>
        <source>Edges shorter than E target lengths are merged with others; off: nothing is merged [0.1]</source>
        <translation>Kanten, die kürzer sind als das E-fache der Ziellänge, werden mit anderen zusammengefasst; off: nichts wird zusammengefasst [0.1]</translation>
    </message>
    <message>
        <source>Faces narrower than W target lengths are merged with neighbours that run on without a corner [0.05]</source>
        <translation>Flächen, die schmaler sind als das W-fache der Ziellänge, werden mit Nachbarn zusammengefasst, die ohne Knick anschließen [0.05]</translation>
    </message>
    <message>
        <source>Order of the elements, 1 or 2 [2]</source>
        <translation>Ordnung der Elemente, 1 oder 2 [2]</translation>
    </message>
    <message>
        <source>quad-dominant; all-quad: triangles only where nothing else is possible; all-triangle [quad-dominant]</source>
        <translation>quad-dominant: vorwiegend Vierecke; all-quad: Dreiecke nur, wo nichts anderes möglich ist; all-triangle: nur Dreiecke [quad-dominant]</translation>
    </message>
    <message>
        <source>Mesh large faces at K times the target length first and divide that mesh: off, auto, 4 to 8 [auto]</source>
        <translation>Große Flächen zuerst mit der K-fachen Ziellänge vernetzen und dieses Netz teilen: off (nein), auto, 4 bis 8 [auto]</translation>
    </message>
    <message>
        <source>Threads to work on; 0: all cores [0]</source>
        <translation>Threads, auf denen gearbeitet wird; 0: alle Kerne [0]</translation>
    </message>
    <message>
        <source>Processes that share the work, by MPI; 0: without MPI [0]</source>
        <translation>Prozesse, die sich die Arbeit teilen, über MPI; 0: ohne MPI [0]</translation>
    </message>
    <message>
        <source>Parts that touch: imprint: share faces and edges; union: only the outer skin is left; none: as drawn [imprint]</source>
        <translation>Teile, die sich berühren: imprint: gemeinsame Flächen und Kanten; union: nur die äußere Haut bleibt; none: wie gezeichnet [imprint]</translation>
    </message>
    <message>
        <source>Largest gap between faces or parts that is closed; 0: never sew [chosen by what it closes]. Negative: automatic</source>
        <translation>Größte Lücke zwischen Flächen oder Teilen, die geschlossen wird; 0: nie [danach gewählt, was sie schließt]. Negativ: automatisch</translation>
    </message>
    <message>
        <source>Refuse models that are not clean, naming what is wrong, instead of repairing them [off]</source>
        <translation>Unsaubere Modelle ablehnen und die Fehler nennen, statt sie zu reparieren [aus]</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Object to mesh: a solid or a surface, an App::Part, a link</source>
        <translation>Was vernetzt wird: ein Körper oder eine Fläche, ein App::Part, eine Verknüpfung</translation>
    </message>
    <message>
        <source>Further objects, meshed together with Part, each where it stands</source>
        <translation>Weitere Objekte, zusammen mit Part vernetzt, jedes an seinem Ort</translation>
    </message>
    <message>
        <source>Refinements: target lengths of faces, edges, vertices and solids</source>
        <translation>Verfeinerungen: Ziellängen von Flächen, Kanten, Punkte und Körpern</translation>
    </message>
    <message>
        <source>Media: what solids are made of</source>
        <translation>Medien: woraus Volumenkörper bestehen</translation>
    </message>
    <message>
        <source>Ports: faces, edges and vertices under names of their own</source>
        <translation>Ports: Flächen, Kanten und Punkte unter eigenen Namen</translation>
    </message>
    <message>
        <source>Wires: edges with a radius</source>
        <translation>Drähte: Kanten mit einem Radius</translation>
    </message>
    <message>
        <source>Radius of edges without a wire of their own, for solvers and scripts: the mesh does not depend on it; 0: not given</source>
        <translation>Radius von Kanten ohne eigenen Draht, für Löser und Skripte: das Netz hängt nicht davon ab; 0: nicht gegeben</translation>
    </message>
    <message>
        <source>Where the window's commands mesh; own process: FreeCAD survives a crash; automatic: there from HeavyElements of the preferences on</source>
        <translation>Wo die Befehle des Fensters vernetzen; Own process: FreeCAD übersteht einen Absturz; Automatic: dort ab HeavyElements der Einstellungen</translation>
    </message>
    <message>
        <source>Processes that share the work, by MPI; 0: without MPI</source>
        <translation>Prozesse, die sich die Arbeit teilen, über MPI; 0: ohne MPI</translation>
    </message>
    <message>
        <source>Not meshed, Up to date, Out of date: the same in all languages, for scripts</source>
        <translation>Not meshed, Up to date, Out of date: in allen Sprachen gleich, für Skripte</translation>
    </message>
    <message>
        <source>Out of date: an option or an object has changed since meshing</source>
        <translation>Veraltet: eine Option oder ein Objekt hat sich seit dem Vernetzen geändert</translation>
    </message>
    <message>
        <source>Number of quads</source>
        <translation>Zahl der Vierecke</translation>
    </message>
    <message>
        <source>Number of triangles</source>
        <translation>Zahl der Dreiecke</translation>
    </message>
    <message>
        <source>Number of line elements of wires</source>
        <translation>Zahl der Linienelemente von Drähten</translation>
    </message>
    <message>
        <source>Number of nodes</source>
        <translation>Zahl der Knoten</translation>
    </message>
    <message>
        <source>Target length of the element edges</source>
        <translation>Ziellänge der Elementkanten</translation>
    </message>
    <message>
        <source>Smallest scaled Jacobian of all elements</source>
        <translation>Kleinste skalierte Jacobi-Determinante aller Elemente</translation>
    </message>
    <message>
        <source>Every mesh edge lies in exactly two elements</source>
        <translation>Jede Netzkante liegt in genau zwei Elementen</translation>
    </message>
    <message>
        <source>Faces that could not be meshed, with the reason</source>
        <translation>Flächen, die nicht vernetzt werden konnten, mit dem Grund</translation>
    </message>
    <message>
        <source>FemMesh holds the mesh: always below the limit of the preferences, above it on demand</source>
        <translation>FemMesh enthält das Netz: unter der Grenze der Einstellungen immer, darüber auf Verlangen</translation>
    </message>
    <message>
        <source>The mesh itself, as the document keeps it</source>
        <translation>Das Netz selbst, wie das Dokument es aufbewahrt</translation>
    </message>
    <message>
        <source>Options that the mesh was made with</source>
        <translation>Optionen, mit denen das Netz erzeugt wurde</translation>
    </message>
    <message>
        <source>Digest of the shape that was meshed</source>
        <translation>Prüfsumme der Form, die vernetzt wurde</translation>
    </message>
    <message>
        <source>The shape differs from the one that was meshed</source>
        <translation>Die Form ist eine andere als die vernetzte</translation>
    </message>
    <message>
        <source>Digest of the labels that faces had when they were meshed</source>
        <translation>Prüfsumme der Bezeichnungen, die Flächen beim Vernetzen hatten</translation>
    </message>
    <message>
        <source>A label that faces are called by differs from then</source>
        <translation>Eine Bezeichnung, nach der Flächen heißen, ist eine andere als damals</translation>
    </message>
    <message>
        <source>Part, under the name that the FEM workbench looks for from FreeCAD 1.0 on</source>
        <translation>Part unter dem Namen, den der Arbeitsbereich FEM ab FreeCAD 1.0 sucht</translation>
    </message>
    <message>
        <source>Mesh options</source>
        <translation>Netzoptionen</translation>
    </message>
    <message>
        <source>Refinement</source>
        <translation>Verfeinerung</translation>
    </message>
    <message>
        <source>Faces, edges, vertices; a whole object means its solids, or its faces where it has none</source>
        <translation>Flächen, Kanten, Punkte; ein ganzes Objekt meint seine Körper oder, wo es keine hat, seine Flächen</translation>
    </message>
    <message>
        <source>What gives the target length: a length, or the wavelength in a medium</source>
        <translation>Was die Ziellänge bestimmt: eine Länge oder die Wellenlänge in einem Medium</translation>
    </message>
    <message>
        <source>Target length there, growing around it by Gradation of the mesh; without effect where that of the mesh is shorter</source>
        <translation>Ziellänge dort, ringsum wachsend mit Gradation des Netzes; ohne Wirkung, wo die des Netzes kürzer ist</translation>
    </message>
    <message>
        <source>Relative permittivity of the medium; needs Frequency of the mesh</source>
        <translation>Relative Permittivität des Mediums; braucht Frequency des Netzes</translation>
    </message>
    <message>
        <source>Relative permeability of the medium</source>
        <translation>Relative Permeabilität des Mediums</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Reihe</translation>
    </message>
    <message>
        <source>The mesh object whose options, refinements and objects all steps have</source>
        <translation>Das Netzobjekt, dessen Optionen, Verfeinerungen und Objekte alle Schritte haben</translation>
    </message>
    <message>
        <source>A mesh object for each step; none where the meshes are files only</source>
        <translation>Ein Netzobjekt für jeden Schritt; keines, wo die Netze nur Dateien sind</translation>
    </message>
    <message>
        <source>The option that differs: frequency, divisions (elements per wavelength), size</source>
        <translation>Die Option, die sich ändert: frequency (Frequenz), divisions (Elemente je Wellenlänge), size (Ziellänge)</translation>
    </message>
    <message>
        <source>Its value at each step: Hz, elements per wavelength, mm</source>
        <translation>Ihr Wert in jedem Schritt: Hz, Elemente je Wellenlänge, mm</translation>
    </message>
    <message>
        <source>Endings of the files that are written for each step</source>
        <translation>Endungen der Dateien, die für jeden Schritt geschrieben werden</translation>
    </message>
    <message>
        <source>Where the files are written</source>
        <translation>Wohin die Dateien geschrieben werden</translation>
    </message>
    <message>
        <source>Names of the mesh objects, one for each step</source>
        <translation>Namen der Netzobjekte, einer für jeden Schritt</translation>
    </message>
    <message>
        <source>What came of each step, as JSON; empty where nothing has yet</source>
        <translation>Was aus jedem Schritt geworden ist, als JSON; leer, wo noch nichts ist</translation>
    </message>
    <message>
        <source>Digest of the shape when the document was saved</source>
        <translation>Prüfsumme der Form, mit der das Dokument gespeichert wurde</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Medium</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Wire</source>
        <translation>Draht</translation>
    </message>
    <message>
        <source>Solids that are made of it; a whole object means its solids</source>
        <translation>Volumenkörper, die daraus bestehen; ein ganzes Objekt meint seine Volumenkörper</translation>
    </message>
    <message>
        <source>Faces, edges and vertices of the port; a whole object means its faces, or its edges where it has none</source>
        <translation>Flächen, Kanten und Punkte des Ports; ein ganzes Objekt meint seine Flächen, oder seine Kanten, wo es keine hat</translation>
    </message>
    <message>
        <source>Edges that stand for the wire; a whole object means all its edges</source>
        <translation>Kanten, die für den Draht stehen; ein ganzes Objekt meint alle seine Kanten</translation>
    </message>
    <message>
        <source>Relative permittivity</source>
        <translation>Relative Permittivität</translation>
    </message>
    <message>
        <source>Relative permeability</source>
        <translation>Relative Permeabilität</translation>
    </message>
    <message>
        <source>Loss tangent: imaginary by real part of the permittivity</source>
        <translation>Verlustfaktor: Imaginär- durch Realteil der Permittivität</translation>
    </message>
    <message>
        <source>The solid is a conductor: no waves inside, its target length is that around it</source>
        <translation>Der Volumenkörper leitet: keine Wellen im Inneren, seine Ziellänge ist die um ihn herum</translation>
    </message>
    <message>
        <source>Radius of the wire, for solvers</source>
        <translation>Radius des Drahts, für Löser</translation>
    </message>
    <message>
        <source>Its name in files of the mesh; empty: the label</source>
        <translation>Sein Name in Dateien des Netzes; leer: die Bezeichnung</translation>
    </message>
    <message>
        <source>Paver colours</source>
        <translation>Paver: Farben</translation>
    </message>
    <message>
        <source>Paver shape</source>
        <translation>Paver: Form</translation>
    </message>
    <message>
        <source>Paver marks</source>
        <translation>Paver: Markierungen</translation>
    </message>
    <message>
        <source>What the colours of the elements tell; local target: as media, refinements and curvature make it; Certificate: whether the curved element is proven not to fold</source>
        <translation>Was die Farben der Elemente zeigen; local target: wie Medien, Verfeinerungen und Krümmung es verlangen; Certificate: ob bewiesen ist, dass das gekrümmte Element sich nicht faltet</translation>
    </message>
    <message>
        <source>Colours of figures; Standard: one made for the quantity</source>
        <translation>Farben der Werte; Standard: eine für die Größe gemachte Farbskala</translation>
    </message>
    <message>
        <source>Standard: the same for all meshes; Data: from the least to the most of this mesh; Manual: from RangeLow to RangeHigh</source>
        <translation>Standard: gleich für alle Netze; Data: vom kleinsten zum größten Wert dieses Netzes; Manual: von RangeLow bis RangeHigh</translation>
    </message>
    <message>
        <source>Lower end of the colours with ColourRange Manual</source>
        <translation>Unteres Ende der Farben bei ColourRange Manual</translation>
    </message>
    <message>
        <source>Upper end of the colours with ColourRange Manual</source>
        <translation>Oberes Ende der Farben bei ColourRange Manual</translation>
    </message>
    <message>
        <source>Shows the colour bar with its histogram in the view</source>
        <translation>Zeigt den Farbbalken mit Histogramm in der Ansicht</translation>
    </message>
    <message>
        <source>Corner of the view for the colour bar; those of several meshes stand side by side</source>
        <translation>Ecke der Ansicht für die Farbskala; die mehrerer Netze stehen nebeneinander</translation>
    </message>
    <message>
        <source>Light and shade; without them the colours are those of the colour bar exactly</source>
        <translation>Licht und Schatten; ohne sie sind die Farben genau die des Farbbalkens</translation>
    </message>
    <message>
        <source>Straight pieces per element edge; 0: as many as the curvature needs and the number of elements allows</source>
        <translation>Gerade Stücke je Elementkante; 0: so viele, wie die Krümmung braucht und die Zahl der Elemente erlaubt</translation>
    </message>
    <message>
        <source>Size of the drawn elements, 1: whole; smaller ones leave gaps that show every element alone</source>
        <translation>Größe der gezeichneten Elemente, 1: ganz; kleinere lassen Lücken, die jedes Element einzeln zeigen</translation>
    </message>
    <message>
        <source>Colour of the element edges</source>
        <translation>Farbe der Elementkanten</translation>
    </message>
    <message>
        <source>Draws the element edges also where they lie so close that they would cover the colours</source>
        <translation>Zeichnet die Elementkanten auch dort, wo sie so dicht liegen, dass sie die Farben verdecken</translation>
    </message>
    <message>
        <source>Shows the outward normal of every element</source>
        <translation>Zeigt die äußere Normale jedes Elements</translation>
    </message>
    <message>
        <source>Marks mesh edges with one element only, and those with more than two</source>
        <translation>Markiert Netzkanten mit nur einem Element und solche mit mehr als zweien</translation>
    </message>
    <message>
        <source>Shows the nodes, with PointSize and PointColor</source>
        <translation>Zeigt die Knoten, mit PointSize und PointColor</translation>
    </message>
    <message>
        <source>Marks the triangles</source>
        <translation>Markiert die Dreiecke</translation>
    </message>
    <message>
        <source>Marks so many elements with the least scaled Jacobian</source>
        <translation>Markiert so viele Elemente mit der kleinsten skalierten Jacobi-Determinante</translation>
    </message>
    <message>
        <source>Shows a part of the mesh alone; Worst elements: as many as ShowWorst asks for; Listed elements: those of IsolatedElements</source>
        <translation>Zeigt einen Teil des Netzes allein; Worst elements: so viele, wie ShowWorst verlangt; Listed elements: die von IsolatedElements</translation>
    </message>
    <message>
        <source>Numbers of the elements that Isolate shows</source>
        <translation>Nummern der Elemente, die Isolate zeigt</translation>
    </message>
    <message>
        <source>Names of faces and objects whose elements are not shown: Face3, Box/Face3, Box</source>
        <translation>Namen von Flächen und Objekten, deren Elemente nicht gezeigt werden: Face3, Box/Face3, Box</translation>
    </message>
    <message>
        <source>Shows figures of the element that was clicked last in the view</source>
        <translation>Zeigt Werte des Elements, das zuletzt in der Ansicht angeklickt wurde</translation>
    </message>
</context>
<context>
    <name>Paver</name>
    <message>
        <source>Reading the shape</source>
        <translation>Form lesen</translation>
    </message>
    <message>
        <source>Joining faces</source>
        <translation>Flächen verbinden</translation>
    </message>
    <message>
        <source>Sizes</source>
        <translation>Größen</translation>
    </message>
    <message>
        <source>Dividing edges</source>
        <translation>Kanten teilen</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Gebiete</translation>
    </message>
    <message>
        <source>Paving</source>
        <translation>Pflastern</translation>
    </message>
    <message>
        <source>Repairing elements</source>
        <translation>Elemente ausbessern</translation>
    </message>
    <message>
        <source>Joining meshes</source>
        <translation>Netze verbinden</translation>
    </message>
    <message>
        <source>Curving</source>
        <translation>Krümmen</translation>
    </message>
    <message>
        <source>Measuring quality</source>
        <translation>Güte messen</translation>
    </message>
    <message>
        <source>Storing</source>
        <translation>Ablegen</translation>
    </message>
    <message>
        <source>'{}' has several meshes now, {}; solvers take one, so remove the others from it.</source>
        <translation>„{}“ hat jetzt mehrere Netze, {}; Löser nehmen eines, entfernen Sie also die anderen daraus.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Six plane faces: a regular grid on each</source>
        <translation>Sechs ebene Flächen: auf jeder ein regelmäßiges Gitter</translation>
    </message>
    <message>
        <source>Box with a cylinder</source>
        <translation>Quader mit Zylinder</translation>
    </message>
    <message>
        <source>A periodic face between plane ones</source>
        <translation>Eine periodische Fläche zwischen ebenen</translation>
    </message>
    <message>
        <source>Cone-sphere</source>
        <translation>Kegelkugel</translation>
    </message>
    <message>
        <source>The tip of a cone and a half sphere</source>
        <translation>Die Spitze eines Kegels und eine Halbkugel</translation>
    </message>
    <message>
        <source>Cone-sphere with a groove</source>
        <translation>Kegelkugel mit Rille</translation>
    </message>
    <message>
        <source>Narrow rings beside large faces</source>
        <translation>Schmale Ringe neben großen Flächen</translation>
    </message>
    <message>
        <source>Cone-sphere as one face</source>
        <translation>Kegelkugel als eine Fläche</translation>
    </message>
    <message>
        <source>One face of revolution with a pole at either end</source>
        <translation>Eine Rotationsfläche mit einem Pol an jedem Ende</translation>
    </message>
    <message>
        <source>Disk with a tiny hole</source>
        <translation>Scheibe mit winzigem Loch</translation>
    </message>
    <message>
        <source>Element sizes from 1 to 20 in one face</source>
        <translation>Elementgrößen von 1 bis 20 in einer Fläche</translation>
    </message>
    <message>
        <source>Plate with a round hole</source>
        <translation>Platte mit rundem Loch</translation>
    </message>
    <message>
        <source>Rows from a circle meet rows from straight sides</source>
        <translation>Reihen um einen Kreis treffen auf Reihen entlang gerader Seiten</translation>
    </message>
    <message>
        <source>Plate with nine holes</source>
        <translation>Platte mit neun Löchern</translation>
    </message>
    <message>
        <source>Ten loops in one face</source>
        <translation>Zehn Randkurven in einer Fläche</translation>
    </message>
    <message>
        <source>Plate with a rectangular hole</source>
        <translation>Platte mit rechteckigem Loch</translation>
    </message>
    <message>
        <source>Corners that turn outwards</source>
        <translation>Einspringende Punkte</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>Pyramide</translation>
    </message>
    <message>
        <source>Acute corners, faces of three sides</source>
        <translation>Spitze Punkte, dreiseitige Flächen</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>One closed face with two poles</source>
        <translation>Eine geschlossene Fläche mit zwei Polen</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>Torus</translation>
    </message>
    <message>
        <source>Closed both ways, no border at all</source>
        <translation>In beiden Richtungen geschlossen, ganz ohne Rand</translation>
    </message>
    <message>
        <source>Wavy patch</source>
        <translation>Gewellte Fläche</translation>
    </message>
    <message>
        <source>A B-spline surface, curved both ways</source>
        <translation>Eine B-Spline-Fläche, in beiden Richtungen gekrümmt</translation>
    </message>
    <message>
        <source>Wind generator</source>
        <translation>Windkraftanlage</translation>
    </message>
    <message>
        <source>Faces of very different size, twisted blades</source>
        <translation>Flächen sehr verschiedener Größe, verwundene Rotorblätter</translation>
    </message>
    <message>
        <source>Wing</source>
        <translation>Tragflügel</translation>
    </message>
    <message>
        <source>A narrow trailing edge beside large faces</source>
        <translation>Eine schmale Hinterkante neben großen Flächen</translation>
    </message>
    <message>
        <source>I-DEAS universal file</source>
        <translation>I-DEAS-Universaldatei</translation>
    </message>
    <message>
        <source>Nastran-like DAT</source>
        <translation>DAT ähnlich Nastran</translation>
    </message>
    <message>
        <source>STL, flat triangles</source>
        <translation>STL, ebene Dreiecke</translation>
    </message>
    <message>
        <source>The mesh of '{}' is out of date ({}).</source>
        <translation>Das Netz von '{}' ist veraltet ({}).</translation>
    </message>
    <message>
        <source>The mesh of '{}' has holes: {} could not be meshed.</source>
        <translation>Das Netz von '{}' hat Löcher: {} ließ sich nicht vernetzen.</translation>
    </message>
    <message>
        <source>{} It is written as it is.</source>
        <translation>{} Es wird geschrieben, wie es ist.</translation>
    </message>
    <message>
        <source>All elements are proven not to fold, curved as they are.</source>
        <translation>Alle Elemente sind nachweislich nicht gefaltet, gekrümmt wie sie sind.</translation>
    </message>
    <message>
        <source>edges sewn</source>
        <translation>Kanten vernäht</translation>
    </message>
    <message>
        <source>open loops closed</source>
        <translation>offene Ränder geschlossen</translation>
    </message>
    <message>
        <source>loops turned</source>
        <translation>Ränder umgedreht</translation>
    </message>
    <message>
        <source>curves put on their surface</source>
        <translation>Kurven auf ihre Fläche gelegt</translation>
    </message>
    <message>
        <source>missing periodic edges added</source>
        <translation>fehlende periodische Kanten ergänzt</translation>
    </message>
    <message>
        <source>missing poles added</source>
        <translation>fehlende Pole ergänzt</translation>
    </message>
    <message>
        <source>missing borders added</source>
        <translation>fehlende Ränder ergänzt</translation>
    </message>
    <message>
        <source>faces turned over</source>
        <translation>Flächen umgedreht</translation>
    </message>
    <message>
        <source>faces dropped that lie on others</source>
        <translation>Flächen entfernt, die auf anderen liegen</translation>
    </message>
    <message>
        <source>{} of {} elements is a triangle.</source>
        <translation>{} von {} Elementen ist ein Dreieck.</translation>
    </message>
    <message>
        <source>{} of {} elements are triangles.</source>
        <translation>{} von {} Elementen sind Dreiecke.</translation>
    </message>
    <message>
        <source>The mesh fits its options and shapes.</source>
        <translation>Das Netz passt zu seinen Optionen und Formen.</translation>
    </message>
    <message>
        <source>{} element folds, or may fold; use a smaller size there.</source>
        <translation>{} Element faltet sich oder könnte es; nehmen Sie dort eine kleinere Länge.</translation>
    </message>
    <message>
        <source>{} elements fold, or may fold; use a smaller size there.</source>
        <translation>{} Elemente falten sich oder könnten es; nehmen Sie dort eine kleinere Länge.</translation>
    </message>
    <message>
        <source>{} element has a scaled Jacobian below {}: {}.</source>
        <translation>{} Element hat eine skalierte Jacobi-Determinante unter {}: {}.</translation>
    </message>
    <message>
        <source>{} elements have a scaled Jacobian below {}; the least is {}.</source>
        <translation>{} Elemente haben eine skalierte Jacobi-Determinante unter {}; die kleinste ist {}.</translation>
    </message>
    <message>
        <source>{} edge or face was merged, of {} mm: {}.</source>
        <translation>{} Kante oder Fläche wurde zusammengefasst, von {} mm: {}.</translation>
    </message>
    <message>
        <source>{} edges and faces were merged, up to {} mm: {}.</source>
        <translation>{} Kanten und Flächen wurden zusammengefasst, bis zu {} mm: {}.</translation>
    </message>
    <message>
        <source>{} pair of parts touches: {}.</source>
        <translation>{} Paar von Teilen berührt sich: {}.</translation>
    </message>
    <message>
        <source>{} pairs of parts touch: {}.</source>
        <translation>{} Paare von Teilen berühren sich: {}.</translation>
    </message>
    <message>
        <source>{} is open where its edges run along each other, {} mm apart.</source>
        <translation>{} ist offen, wo Kanten im Abstand von {} mm nebeneinander verlaufen.</translation>
    </message>
    <message>
        <source>{} come within {} mm of each other and share no node there.</source>
        <translation>{} kommen einander auf {} mm nahe und haben dort keinen Knoten gemeinsam.</translation>
    </message>
    <message>
        <source>All elements are quads.</source>
        <translation>Alle Elemente sind Vierecke.</translation>
    </message>
    <message>
        <source>{} edge is longer than {} of the target length.</source>
        <translation>{} Kante ist länger als das {}-Fache der Ziellänge.</translation>
    </message>
    <message>
        <source>{} edges are longer than {} of the target length.</source>
        <translation>{} Kanten sind länger als das {}-Fache der Ziellänge.</translation>
    </message>
    <message>
        <source>{} edge is far shorter than wanted, {} mm instead of {} mm; remove small details of the model, or refine there.</source>
        <translation>{} Kante ist viel kürzer als gewünscht, {} mm statt {} mm; kleine Details des Modells entfernen oder dort verfeinern.</translation>
    </message>
    <message>
        <source>{} edges are far shorter than wanted, the worst {} mm instead of {} mm; remove small details of the model, or refine there.</source>
        <translation>{} Kanten sind viel kürzer als gewünscht, die schlimmste {} mm statt {} mm; kleine Details des Modells entfernen oder dort verfeinern.</translation>
    </message>
    <message>
        <source>There are no elements but lines of wires.</source>
        <translation>Es gibt keine Elemente außer Linien von Drähten.</translation>
    </message>
    <message>
        <source>The mesh is out of date ({}).</source>
        <translation>Das Netz ist veraltet ({}).</translation>
    </message>
    <message>
        <source>No scaled Jacobian is below {}; the least is {}.</source>
        <translation>Keine skalierte Jacobi-Determinante liegt unter {}; die kleinste ist {}.</translation>
    </message>
    <message>
        <source>{} mesh edge has more than two elements: sheets meet there.</source>
        <translation>{} Netzkante hat mehr als zwei Elemente: Dort treffen sich Bleche.</translation>
    </message>
    <message>
        <source>{} mesh edges have more than two elements: sheets meet there.</source>
        <translation>{} Netzkanten haben mehr als zwei Elemente: Dort treffen sich Bleche.</translation>
    </message>
    <message>
        <source>{} mesh edge is free: the surface is open there.</source>
        <translation>{} Netzkante ist frei: Dort ist die Oberfläche offen.</translation>
    </message>
    <message>
        <source>{} mesh edges are free: the surface is open there.</source>
        <translation>{} Netzkanten sind frei: Dort ist die Oberfläche offen.</translation>
    </message>
    <message>
        <source>The mesh has no free edge.</source>
        <translation>Das Netz hat keine freie Kante.</translation>
    </message>
    <message>
        <source>{} is not meshed: {}.</source>
        <translation>{} ist nicht vernetzt: {}.</translation>
    </message>
    <message>
        <source>Not in the mesh: {}; name what stays, or mend what fails.</source>
        <translation>Nicht im Netz: {}; benennen Sie, was bleibt, oder beheben Sie, was misslingt.</translation>
    </message>
    <message>
        <source>The model was repaired: {}.</source>
        <translation>Das Modell wurde repariert: {}.</translation>
    </message>
    <message>
        <source>There are {} separate meshes, which share no node: {}.</source>
        <translation>Es sind {} getrennte Netze ohne gemeinsame Knoten: {}.</translation>
    </message>
    <message>
        <source>{} touch but could not be connected; repair or fuse them.</source>
        <translation>{} berühren sich, ließen sich aber nicht verbinden; bitte reparieren oder vereinigen.</translation>
    </message>
    <message>
        <source>The faces of {} cannot all look outwards; repair the solid.</source>
        <translation>Die Flächen von {} können nicht alle nach außen zeigen; bitte den Körper reparieren.</translation>
    </message>
    <message>
        <source>{} is open: faces are missing or do not meet.</source>
        <translation>{} ist offen: Flächen fehlen oder treffen sich nicht.</translation>
    </message>
    <message>
        <source>Not read, or not as the file has it: {}.</source>
        <translation>Nicht gelesen, oder nicht, wie die Datei es hat: {}.</translation>
    </message>
    <message>
        <source>Elements run through each other: {}.</source>
        <translation>Elemente durchdringen einander: {}.</translation>
    </message>
    <message>
        <source>No edge is longer than {} of the target length.</source>
        <translation>Keine Kante ist länger als das {}-Fache der Ziellänge.</translation>
    </message>
    <message>
        <source>No edge is shorter than {} of the target length at its place.</source>
        <translation>Keine Kante ist kürzer als {} der Ziellänge an ihrem Ort.</translation>
    </message>
    <message>
        <source>an option or a shape has changed; mesh again</source>
        <translation>eine Option oder Form hat sich geändert; neu vernetzen</translation>
    </message>
    <message>
        <source>Not meshed</source>
        <translation>Nicht vernetzt</translation>
    </message>
    <message>
        <source>Up to date</source>
        <translation>Aktuell</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Veraltet</translation>
    </message>
    <message>
        <source>Faces failed</source>
        <translation>Flächen nicht vernetzt</translation>
    </message>
    <message>
        <source>a shape</source>
        <translation>eine Form</translation>
    </message>
    <message>
        <source>a label</source>
        <translation>eine Bezeichnung</translation>
    </message>
    <message>
        <source>changed: {}; mesh again</source>
        <translation>geändert: {}; neu vernetzen</translation>
    </message>
    <message>
        <source>a refinement</source>
        <translation>eine Verfeinerung</translation>
    </message>
    <message>
        <source>a medium, port or wire</source>
        <translation>ein Medium, Port oder Draht</translation>
    </message>
    <message>
        <source>'{}' is not meshed; mesh it first.</source>
        <translation>'{}' ist nicht vernetzt; vernetzen Sie es zuerst.</translation>
    </message>
    <message>
        <source>The shape of '{}' has changed since meshing, so its elements tell no faces; mesh it again, or select faces of the model.</source>
        <translation>Die Form von '{}' hat sich seit dem Vernetzen geändert, so dass seine Elemente keine Flächen bezeichnen; vernetzen Sie neu oder wählen Sie Flächen des Modells.</translation>
    </message>
    <message>
        <source>'{}' refers to no face of what '{}' meshes, so solvers leave it out; refer to faces of that.</source>
        <translation>„{}“ bezieht sich auf keine Fläche dessen, was „{}“ vernetzt, sodass Löser es auslassen; wählen Sie Flächen davon.</translation>
    </message>
    <message>
        <source>'{}' stays outside of '{}', which would move it: its elements lie where the model stands already.</source>
        <translation>„{}“ bleibt außerhalb von „{}“, das es verschieben würde: Seine Elemente liegen schon da, wo das Modell steht.</translation>
    </message>
    <message>
        <source>'{}' has no object to mesh; set its property Part.</source>
        <translation>'{}' hat kein Objekt zum Vernetzen; setzen Sie seine Eigenschaft Part.</translation>
    </message>
    <message>
        <source>'{}' has no length; give one, or eps_r and mu_r of a medium.</source>
        <translation>'{}' hat keine Länge; geben Sie eine an, oder eps_r und mu_r eines Mediums.</translation>
    </message>
    <message>
        <source>The length of '{}' is {}; give one above 0, like 2 or "2 mm".</source>
        <translation>Die Länge von '{}' ist {}; geben Sie eine über 0 an, etwa 2 oder "2 mm".</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>divisions</source>
        <translation>Elemente je Wellenlänge</translation>
    </message>
    <message>
        <source>size</source>
        <translation>Ziellänge</translation>
    </message>
    <message>
        <source>A series varies one thing; give it frequencies, or divisions, or sizes.</source>
        <translation>Eine Reihe ändert eine Sache; geben Sie ihr frequencies oder divisions oder sizes.</translation>
    </message>
    <message>
        <source>The model, the options or the mesh have changed since; this row is of before.</source>
        <translation>Modell, Optionen oder Netz sind seitdem geändert worden; diese Zeile ist von vorher.</translation>
    </message>
    <message>
        <source>The {} {} of a series cannot be read; write a value above 0, such as {}.</source>
        <translation>{} {} einer Reihe ist nicht lesbar; schreiben Sie einen Wert über 0, etwa {}.</translation>
    </message>
    <message>
        <source>A range of a series goes from a value to a larger one in 2 to {} steps, such as 1GHz:4GHz:7 or 1GHz:4GHz:7:log.</source>
        <translation>Ein Bereich einer Reihe geht von einem Wert zu einem größeren in 2 bis {} Schritten, etwa 1GHz:4GHz:7 oder 1GHz:4GHz:7:log.</translation>
    </message>
    <message>
        <source>A series has 1 to {} values of {}, not {}.</source>
        <translation>Eine Reihe hat 1 bis {} Werte von {}, nicht {}.</translation>
    </message>
    <message>
        <source>'{}' has no frequency, so there are no elements per wavelength to vary; give it one, or vary the size.</source>
        <translation>'{}' hat keine Frequenz, daher auch keine Elemente je Wellenlänge; geben Sie ihm eine oder ändern Sie die Ziellänge.</translation>
    </message>
    <message>
        <source>Files cannot be written to the folder '{}'; choose one that exists and can be written to.</source>
        <translation>In den Ordner '{}' kann nicht geschrieben werden; wählen Sie einen, den es gibt und in den geschrieben werden darf.</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>Edge length</source>
        <translation>Kantenlänge</translation>
    </message>
    <message>
        <source>Element area</source>
        <translation>Elementfläche</translation>
    </message>
    <message>
        <source>In the densest medium</source>
        <translation>Im dichtesten Medium</translation>
    </message>
    <message>
        <source>Scaled Jacobian</source>
        <translation>Skalierte Jacobi-Determinante</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>Kleinste</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größte</translation>
    </message>
    <message>
        <source>Quads</source>
        <translation>Vierecke</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Gesamt</translation>
    </message>
    <message>
        <source>Basis order 1 (rooftops, RWG)</source>
        <translation>Basisordnung 1 (Rooftops, RWG)</translation>
    </message>
    <message>
        <source>Basis order 2</source>
        <translation>Basisordnung 2</translation>
    </message>
    <message>
        <source>Basis order 3</source>
        <translation>Basisordnung 3</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Elements per λ²</source>
        <translation>Elemente je λ²</translation>
    </message>
    <message>
        <source>Wavelength</source>
        <translation>Wellenlänge</translation>
    </message>
    <message>
        <source>Shortest edge</source>
        <translation>Kürzeste Kante</translation>
    </message>
    <message>
        <source>Longest edge</source>
        <translation>Längste Kante</translation>
    </message>
    <message>
        <source>Fewest elements per λ²</source>
        <translation>Wenigste Elemente je λ²</translation>
    </message>
    <message>
        <source>Unknowns (conductor)</source>
        <translation>Unbekannte (Leiter)</translation>
    </message>
    <message>
        <source>a number without a unit</source>
        <translation>eine Zahl ohne Einheit</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>eine Länge</translation>
    </message>
    <message>
        <source>a frequency</source>
        <translation>eine Frequenz</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>einen Winkel</translation>
    </message>
    <message>
        <source>{} of '{}' is {}; give it {}, or an expression that comes to one.</source>
        <translation>{} von „{}“ ist {}; geben Sie {} ein oder einen Ausdruck, der das ergibt.</translation>
    </message>
    <message>
        <source>{} of '{}' no longer follows its expression {}: it was given another value.</source>
        <translation>{} von „{}“ folgt nicht mehr dem Ausdruck {}: Es hat einen anderen Wert bekommen.</translation>
    </message>
    <message>
        <source>{} of '{}' is {}; give one from 0.</source>
        <translation>{} von '{}' ist {}; geben Sie einen Wert ab 0 an.</translation>
    </message>
    <message>
        <source>{} of '{}' is {}; give one above 0.</source>
        <translation>{} von '{}' ist {}; geben Sie einen Wert über 0 an.</translation>
    </message>
    <message>
        <source>port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>wire</source>
        <translation>Draht</translation>
    </message>
    <message>
        <source>{} of '{}' cannot be in a {}; choose {}.</source>
        <translation>{} von '{}' kann nicht in einem {} sein; wählen Sie {}.</translation>
    </message>
    <message>
        <source>{} of '{}' cannot be {}; write a number.</source>
        <translation>{} von '{}' kann nicht {} sein; schreiben Sie eine Zahl.</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>Eckpunkt</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>Volumenkörper</translation>
    </message>
    <message>
        <source>'{}' refers to {} of '{}', which is not among the objects that are meshed; refer to elements of those.</source>
        <translation>'{}' verweist auf {} von '{}', was nicht zu den Objekten gehört, die vernetzt werden; verweisen Sie auf Elemente von diesen.</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>What is to belong to '{}' refers to nothing; select faces, edges, vertices or objects.</source>
        <translation>Was zu '{}' gehören soll, verweist auf nichts; wählen Sie Flächen, Kanten, Eckpunkte oder Objekte.</translation>
    </message>
    <message>
        <source>'{}' refers to {}, which '{}' does not have; choose the elements again.</source>
        <translation>'{}' verweist auf {}, das '{}' nicht hat; wählen Sie die Elemente neu.</translation>
    </message>
    <message>
        <source>'{}' refers to '{}', which has no {}; choose another object.</source>
        <translation>'{}' verweist auf '{}', was nichts davon hat: {}; wählen Sie ein anderes Objekt.</translation>
    </message>
    <message>
        <source>The mesh has errors.</source>
        <translation>Das Netz hat Fehler.</translation>
    </message>
    <message>
        <source>The mesh can be used; look at the warnings.</source>
        <translation>Das Netz ist brauchbar; beachten Sie die Warnungen.</translation>
    </message>
    <message>
        <source>The mesh is sound.</source>
        <translation>Das Netz ist in Ordnung.</translation>
    </message>
    <message>
        <source>Click on a line to go to its elements in the 3D view, which get rings</source>
        <translation>Klick auf eine Zeile führt zu ihren Elementen in der 3D-Ansicht, die Ringe bekommen</translation>
    </message>
    <message>
        <source>Figures of the element in the middle of the view</source>
        <translation>Zahlen des Elements in der Mitte der Ansicht</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Goes to the previous element of the finding</source>
        <translation>Führt zum vorigen Element des Befunds</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Goes to the next element of the finding</source>
        <translation>Führt zum nächsten Element des Befunds</translation>
    </message>
    <message>
        <source>Shows the elements of the finding alone</source>
        <translation>Zeigt die Elemente des Befunds allein</translation>
    </message>
    <message>
        <source>Number of an element; Return goes to it</source>
        <translation>Nummer eines Elements; Eingabetaste führt zu ihm</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isolieren</translation>
    </message>
    <message>
        <source>Only these</source>
        <translation>Nur diese</translation>
    </message>
    <message>
        <source>Element</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Noch einmal prüfen</translation>
    </message>
    <message>
        <source>Check of {}</source>
        <translation>Prüfung von {}</translation>
    </message>
    <message>
        <source>{} of {}</source>
        <translation>{} von {}</translation>
    </message>
    <message>
        <source>Writing {}</source>
        <translation>{} wird geschrieben</translation>
    </message>
    <message>
        <source>Reading {}</source>
        <translation>{} wird gelesen</translation>
    </message>
    <message>
        <source>Written: {}</source>
        <translation>Geschrieben: {}</translation>
    </message>
    <message>
        <source>{} Nothing was written.</source>
        <translation>{} Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>The document was closed before '{}' was read.</source>
        <translation>Das Dokument wurde geschlossen, bevor „{}“ gelesen war.</translation>
    </message>
    <message>
        <source>Help on Paver</source>
        <translation>Hilfe zu Paver</translation>
    </message>
    <message>
        <source>Relative permittivity</source>
        <translation>Relative Permittivität</translation>
    </message>
    <message>
        <source>Relative permeability</source>
        <translation>Relative Permeabilität</translation>
    </message>
    <message>
        <source>Loss tangent</source>
        <translation>Verlustfaktor</translation>
    </message>
    <message>
        <source>Imaginary by real part of the permittivity</source>
        <translation>Imaginär- durch Realteil der Permittivität</translation>
    </message>
    <message>
        <source>Conductor</source>
        <translation>Leiter</translation>
    </message>
    <message>
        <source>No waves inside: the target length is that around it</source>
        <translation>Keine Wellen im Inneren: die Ziellänge ist die um ihn herum</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius of the wire, for solvers</source>
        <translation>Radius des Drahts, für Löser</translation>
    </message>
    <message>
        <source>Its name in files of the mesh</source>
        <translation>Sein Name in Dateien des Netzes</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Takes the values of a material of the document or of FreeCAD's cards that have some</source>
        <translation>Nimmt die Werte eines Materials des Dokuments oder der Karten von FreeCAD, die welche haben</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>Wie eingegeben</translation>
    </message>
    <message>
        <source>It has no name; write one.</source>
        <translation>Der Name fehlt; geben Sie einen ein.</translation>
    </message>
    <message>
        <source>It refers to nothing; add faces, edges, vertices or objects.</source>
        <translation>Es ist nichts gewählt; fügen Sie Flächen, Kanten, Punkte oder Objekte hinzu.</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Change {}</source>
        <translation>{} ändern</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>{} is not above 0; write a larger number.</source>
        <translation>{} ist nicht größer als 0; schreiben Sie eine größere Zahl.</translation>
    </message>
    <message>
        <source>Whether elements become shorter</source>
        <translation>Ob die Elemente kürzer werden</translation>
    </message>
    <message>
        <source>Relative permittivity of the medium there</source>
        <translation>Relative Permittivität des Mediums dort</translation>
    </message>
    <message>
        <source>Relative permeability of the medium there</source>
        <translation>Relative Permeabilität des Mediums dort</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Durch</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Medium εr</source>
        <translation>Medium εr</translation>
    </message>
    <message>
        <source>μr</source>
        <translation>μr</translation>
    </message>
    <message>
        <source>Nothing is refined; add faces, edges, vertices or objects.</source>
        <translation>Nichts wird verfeinert; fügen Sie Flächen, Kanten, Punkte oder Objekte hinzu.</translation>
    </message>
    <message>
        <source>Size of {}</source>
        <translation>Länge von {}</translation>
    </message>
    <message>
        <source>Target length there, such as {}</source>
        <translation>Ziellänge dort, etwa {}</translation>
    </message>
    <message>
        <source>Meshing in a process of its own</source>
        <translation>Vernetzt in einem eigenen Prozess</translation>
    </message>
    <message>
        <source>Meshing of '{}' was stopped, as it was deleted.</source>
        <translation>Das Vernetzen von „{}“ wurde angehalten, weil es gelöscht wurde.</translation>
    </message>
    <message>
        <source>'{}' has {} quads and {} triangles</source>
        <translation>„{}“ hat {} Vierecke und {} Dreiecke</translation>
    </message>
    <message>
        <source>, but {} could not be meshed: {}.</source>
        <translation>, aber {} ließ sich nicht vernetzen: {}.</translation>
    </message>
    <message>
        <source>{} face is meshed.</source>
        <translation>{} Fläche ist vernetzt.</translation>
    </message>
    <message>
        <source>{} faces are meshed.</source>
        <translation>{} Flächen sind vernetzt.</translation>
    </message>
    <message>
        <source>Shape of {:.2f} MB handed over in {:.2f} s</source>
        <translation>Form von {:.2f} MB übergeben in {:.2f} s</translation>
    </message>
    <message>
        <source>'{}' is being meshed; wait for that or stop it first.</source>
        <translation>'{}' wird gerade vernetzt; warten Sie darauf oder halten Sie das zuerst an.</translation>
    </message>
    <message>
        <source>{} face is not meshed.</source>
        <translation>{} Fläche ist nicht vernetzt.</translation>
    </message>
    <message>
        <source>{} faces are not meshed.</source>
        <translation>{} Flächen sind nicht vernetzt.</translation>
    </message>
    <message>
        <source>{} element was repaired: {}.</source>
        <translation>{} Element wurde repariert: {}.</translation>
    </message>
    <message>
        <source>{} elements were repaired: {}.</source>
        <translation>{} Elemente wurden repariert: {}.</translation>
    </message>
    <message>
        <source>{:.2f} s of meshing, {:.2f} s to take it into the document</source>
        <translation>{:.2f} s vernetzt, {:.2f} s für die Aufnahme ins Dokument</translation>
    </message>
    <message>
        <source>Meshing of '{}' was stopped; it is as before.</source>
        <translation>Das Vernetzen von „{}“ wurde angehalten; es ist wie zuvor.</translation>
    </message>
    <message>
        <source>What may trouble a solver</source>
        <translation>Was einem Löser Mühe machen kann</translation>
    </message>
    <message>
        <source>Frequency for the figures in wavelengths; the mesh stays as it is</source>
        <translation>Frequenz für die Angaben in Wellenlängen; das Netz bleibt, wie es ist</translation>
    </message>
    <message>
        <source>Edge lengths</source>
        <translation>Kantenlängen</translation>
    </message>
    <message>
        <source>Element areas</source>
        <translation>Elementflächen</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>In wavelengths, memory</source>
        <translation>In Wellenlängen, Speicher</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>Tabelle kopieren</translation>
    </message>
    <message>
        <source>Give a frequency to see wavelengths</source>
        <translation>Geben Sie eine Frequenz an, um Wellenlängen zu sehen</translation>
    </message>
    <message>
        <source>Statistics of {}</source>
        <translation>Statistik von {}</translation>
    </message>
    <message>
        <source>Puts the options into the mesh object, without meshing, and closes; a run goes on</source>
        <translation>Übernimmt die Optionen in das Netzobjekt, ohne zu vernetzen, und schließt; ein Lauf geht weiter</translation>
    </message>
    <message>
        <source>Meshes with these options, like the button Mesh; the panel stays open</source>
        <translation>Vernetzt mit diesen Optionen, wie die Schaltfläche Vernetzen; das Fenster bleibt offen</translation>
    </message>
    <message>
        <source>Drops changes that were neither meshed with nor confirmed by OK, stops a run and closes</source>
        <translation>Verwirft Änderungen, mit denen weder vernetzt wurde noch die OK bestätigt hat, hält einen Lauf an und schließt</translation>
    </message>
    <message>
        <source>Predicting...</source>
        <translation>Vorhersage ...</translation>
    </message>
    <message>
        <source>Options of {}</source>
        <translation>Optionen von {}</translation>
    </message>
    <message>
        <source>Curved quadrilateral meshes of surfaces for Method-of-Moments solvers</source>
        <translation>Gekrümmte Vierecksnetze von Oberflächen für Löser der Momentenmethode</translation>
    </message>
    <message>
        <source>This FreeCAD is built without its FEM module, which mesh objects need; install one that has it.</source>
        <translation>Dieses FreeCAD ist ohne sein Modul FEM gebaut, das Netzobjekte brauchen; installieren Sie eines, das es hat.</translation>
    </message>
    <message>
        <source>Another task panel is open; close it first.</source>
        <translation>Ein anderes Aufgabenfenster ist offen; schließen Sie es zuerst.</translation>
    </message>
    <message>
        <source>The mesh is being measured; the window can be used meanwhile</source>
        <translation>Das Netz wird vermessen; das Fenster bleibt bedienbar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stops it; the document stays as it was</source>
        <translation>Hält es an; das Dokument bleibt, wie es war</translation>
    </message>
    <message>
        <source>Stopped: {}</source>
        <translation>Angehalten: {}</translation>
    </message>
    <message>
        <source>a few seconds left</source>
        <translation>noch einige Sekunden</translation>
    </message>
    <message>
        <source>about {} h left</source>
        <translation>noch etwa {} h</translation>
    </message>
    <message>
        <source>about {} s left</source>
        <translation>noch etwa {} s</translation>
    </message>
    <message>
        <source>about {} min left</source>
        <translation>noch etwa {} min</translation>
    </message>
    <message>
        <source>Good: nothing is wrong with the mesh.</source>
        <translation>Gut: Am Netz ist nichts auszusetzen.</translation>
    </message>
    <message>
        <source>Error: {}</source>
        <translation>Fehler: {}</translation>
    </message>
    <message>
        <source>Warning: {}</source>
        <translation>Warnung: {}</translation>
    </message>
    <message>
        <source>The worst that a check of the mesh has found</source>
        <translation>Das Schlimmste, was eine Prüfung des Netzes gefunden hat</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Opens the list of all that was found, and goes to its places</source>
        <translation>Öffnet die Liste von allem, was gefunden wurde, und führt zu den Stellen</translation>
    </message>
    <message>
        <source>Checking the mesh...</source>
        <translation>Netz wird geprüft ...</translation>
    </message>
    <message>
        <source>Good. {}</source>
        <translation>Gut. {}</translation>
    </message>
    <message>
        <source>({} more)</source>
        <translation>({} weitere)</translation>
    </message>
    <message>
        <source>What went wrong, and what to do</source>
        <translation>Was schiefging, und was zu tun ist</translation>
    </message>
    <message>
        <source>Export mesh</source>
        <translation>Netz exportieren</translation>
    </message>
    <message>
        <source>Export the old mesh</source>
        <translation>Altes Netz exportieren</translation>
    </message>
    <message>
        <source>Export with holes</source>
        <translation>Mit Löchern exportieren</translation>
    </message>
    <message>
        <source>Mesh first</source>
        <translation>Erst vernetzen</translation>
    </message>
    <message>
        <source>{} is there already. Replace it?</source>
        <translation>{} gibt es schon. Soll die Datei ersetzt werden?</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Import mesh</source>
        <translation>Netz importieren</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>Netze</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Alle Dateien</translation>
    </message>
    <message>
        <source>There are several meshes; select the one that it belongs to, too.</source>
        <translation>Es gibt mehrere Netze; wählen Sie auch das, zu dem es gehört.</translation>
    </message>
    <message>
        <source>No mesh has what is selected. Select its mesh, too, or make one with Create mesh.</source>
        <translation>Kein Netz hat, was ausgewählt ist. Wählen Sie sein Netz dazu aus, oder legen Sie mit „Netz anlegen“ eines an.</translation>
    </message>
    <message>
        <source>Nothing of the mesh is selected. Click on its elements in the 3D view first, with Ctrl on several.</source>
        <translation>Vom Netz ist nichts ausgewählt. Erst in der 3D-Ansicht auf seine Elemente klicken, mit Strg auf mehrere.</translation>
    </message>
    <message>
        <source>Quad</source>
        <translation>Viereck</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>Element type</source>
        <translation>Elementart</translation>
    </message>
    <message>
        <source>Source face</source>
        <translation>Ursprungsfläche</translation>
    </message>
    <message>
        <source>Valid, proven</source>
        <translation>Gültig, bewiesen</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Umgestülpt</translation>
    </message>
    <message>
        <source>Undecided</source>
        <translation>Unentschieden</translation>
    </message>
    <message>
        <source>Longest edge / target</source>
        <translation>Längste Kante / Ziellänge</translation>
    </message>
    <message>
        <source>Longest edge / local target</source>
        <translation>Längste Kante / örtliche Ziellänge</translation>
    </message>
    <message>
        <source>target {}</source>
        <translation>Ziel {}</translation>
    </message>
    <message>
        <source>Certificate, order {}</source>
        <translation>Zertifikat, Ordnung {}</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>{} more</source>
        <translation>{} weitere</translation>
    </message>
    <message>
        <source>valid, proven</source>
        <translation>gültig, bewiesen</translation>
    </message>
    <message>
        <source>inverted</source>
        <translation>umgestülpt</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>unentschieden</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Edges / λ</source>
        <translation>Kanten / λ</translation>
    </message>
    <message>
        <source>Longest / target</source>
        <translation>Längste / Ziellänge</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Flächeninhalt</translation>
    </message>
    <message>
        <source>{} element</source>
        <translation>{} Element</translation>
    </message>
    <message>
        <source>{} elements</source>
        <translation>{} Elemente</translation>
    </message>
    <message>
        <source>edges {}</source>
        <translation>Kanten {}</translation>
    </message>
    <message>
        <source>Order {}</source>
        <translation>Ordnung {}</translation>
    </message>
    <message>
        <source>Jacobian ratio {}</source>
        <translation>Jacobi-Verhältnis {}</translation>
    </message>
    <message>
        <source>Out of date: {}</source>
        <translation>Veraltet: {}</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>A length, or the wavelength in a medium, which needs a frequency</source>
        <translation>Eine Länge, oder die Wellenlänge in einem Medium, wozu es eine Frequenz braucht</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>selbsttätig</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Medium</translation>
    </message>
    <message>
        <source>No effect: {} is not below the target length of the mesh, {}.</source>
        <translation>Ohne Wirkung: {} liegt nicht unter der Ziellänge des Netzes, {}.</translation>
    </message>
    <message>
        <source>Quad-dominant</source>
        <translation>Überwiegend Vierecke</translation>
    </message>
    <message>
        <source>All quads</source>
        <translation>Nur Vierecke</translation>
    </message>
    <message>
        <source>All triangles</source>
        <translation>Nur Dreiecke</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Selbsttätig</translation>
    </message>
    <message>
        <source>One element across</source>
        <translation>Ein Element quer</translation>
    </message>
    <message>
        <source>imprint</source>
        <translation>gemeinsame Flächen (imprint)</translation>
    </message>
    <message>
        <source>union</source>
        <translation>nur äußere Haut (union)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>wie gezeichnet (none)</translation>
    </message>
    <message>
        <source>1 (straight)</source>
        <translation>1 (gerade)</translation>
    </message>
    <message>
        <source>2 (curved)</source>
        <translation>2 (gekrümmt)</translation>
    </message>
    <message>
        <source>'{}' cannot be read; write {}.</source>
        <translation>„{}“ ist nicht lesbar; schreiben Sie {}.</translation>
    </message>
    <message>
        <source>'{}' cannot be read; write a number and a unit, such as {}.</source>
        <translation>„{}“ ist nicht lesbar; schreiben Sie eine Zahl und eine Einheit, etwa {}.</translation>
    </message>
    <message>
        <source>A value is missing; write one, such as {}.</source>
        <translation>Ein Wert fehlt; schreiben Sie einen, etwa {}.</translation>
    </message>
    <message>
        <source>{} times as long</source>
        <translation>{}-mal so lang</translation>
    </message>
    <message>
        <source>{} elements across</source>
        <translation>{} Elemente quer</translation>
    </message>
    <message>
        <source>Target length</source>
        <translation>Ziellänge</translation>
    </message>
    <message>
        <source>Elements per λ</source>
        <translation>Elemente je λ</translation>
    </message>
    <message>
        <source>Turn per edge</source>
        <translation>Drehung je Kante</translation>
    </message>
    <message>
        <source>Narrower at ridges by</source>
        <translation>An Graten schmaler um</translation>
    </message>
    <message>
        <source>Gradation</source>
        <translation>Gradation</translation>
    </message>
    <message>
        <source>Finer at tips by</source>
        <translation>An Spitzen feiner um</translation>
    </message>
    <message>
        <source>Finer at edges by</source>
        <translation>An Kanten feiner um</translation>
    </message>
    <message>
        <source>Narrow gaps</source>
        <translation>Schmale Streifen</translation>
    </message>
    <message>
        <source>Merge edges below</source>
        <translation>Kanten zusammenfassen unter</translation>
    </message>
    <message>
        <source>Merge faces below</source>
        <translation>Flächen zusammenfassen unter</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Größter Abstand</translation>
    </message>
    <message>
        <source>Most elements</source>
        <translation>Höchstens Elemente</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>Coarse mesh first</source>
        <translation>Zuerst grobes Netz</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>MPI processes</source>
        <translation>MPI-Prozesse</translation>
    </message>
    <message>
        <source>Sew gaps up to</source>
        <translation>Lücken schließen bis</translation>
    </message>
    <message>
        <source>Parts that touch</source>
        <translation>Teile, die sich berühren</translation>
    </message>
    <message>
        <source>Clean models only</source>
        <translation>Nur saubere Modelle</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Elements of one target length</source>
        <translation>Elemente einer Ziellänge</translation>
    </message>
    <message>
        <source>Elements as long as a part of the wavelength</source>
        <translation>Elemente so lang wie ein Teil der Wellenlänge</translation>
    </message>
    <message>
        <source>Wavelength in the medium, at the frequency</source>
        <translation>Wellenlänge im Medium, bei der Frequenz</translation>
    </message>
    <message>
        <source>More options</source>
        <translation>Weitere Optionen</translation>
    </message>
    <message>
        <source>Curvature, gradation, limits, sewing, where to mesh</source>
        <translation>Krümmung, Gradation, Grenzen, Lücken, wo vernetzt wird</translation>
    </message>
    <message>
        <source>FreeCAD</source>
        <translation>FreeCAD</translation>
    </message>
    <message>
        <source>Own process</source>
        <translation>Eigener Prozess</translation>
    </message>
    <message>
        <source>Mesh in</source>
        <translation>Vernetzen in</translation>
    </message>
    <message>
        <source>In a process of its own a crash cannot harm FreeCAD; automatic: from {} predicted elements on</source>
        <translation>In einem eigenen Prozess kann ein Absturz FreeCAD nicht schaden; selbsttätig: ab {} vorhergesagten Elementen</translation>
    </message>
    <message>
        <source>What it refers to; a click shows it in the 3D view</source>
        <translation>Worauf es sich bezieht; ein Klick zeigt es in der 3D-Ansicht</translation>
    </message>
    <message>
        <source>Add selection</source>
        <translation>Auswahl hinzufügen</translation>
    </message>
    <message>
        <source>Adds what is selected in the 3D view</source>
        <translation>Fügt hinzu, was in der 3D-Ansicht ausgewählt ist</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the chosen lines</source>
        <translation>Entfernt die gewählten Zeilen</translation>
    </message>
    <message>
        <source>Nothing of the model is selected; select faces, edges, vertices or objects in the 3D view.</source>
        <translation>Vom Modell ist nichts ausgewählt; wählen Sie Flächen, Kanten, Punkte oder Objekte in der 3D-Ansicht.</translation>
    </message>
    <message>
        <source>Quads and triangles</source>
        <translation>Vierecke und Dreiecke</translation>
    </message>
    <message>
        <source>Elements with four sides</source>
        <translation>Elemente mit vier Seiten</translation>
    </message>
    <message>
        <source>Elements with three sides</source>
        <translation>Elemente mit drei Seiten</translation>
    </message>
    <message>
        <source>Of all orders</source>
        <translation>Aller Ordnungen</translation>
    </message>
    <message>
        <source>Smallest and mean; 1 is a square or an equilateral triangle, 0 a degenerate element</source>
        <translation>Kleinste und mittlere; 1 ist ein Quadrat oder gleichseitiges Dreieck, 0 ein entartetes Element</translation>
    </message>
    <message>
        <source>Shortest and longest element edge, end to end</source>
        <translation>Kürzeste und längste Elementkante, von Ende zu Ende</translation>
    </message>
    <message>
        <source>Mean edge</source>
        <translation>Mittlere Kante</translation>
    </message>
    <message>
        <source>Mean length of the element edges</source>
        <translation>Mittlere Länge der Elementkanten</translation>
    </message>
    <message>
        <source>Away from bends and local sizes</source>
        <translation>Abseits von Biegungen und örtlichen Längen</translation>
    </message>
    <message>
        <source>Edges 0.7–1.4 target</source>
        <translation>Kanten 0,7–1,4 Ziel</translation>
    </message>
    <message>
        <source>Edges between 0.7 and 1.4 of the length wanted there</source>
        <translation>Kanten zwischen dem 0,7- und 1,4-Fachen der dort gewünschten Länge</translation>
    </message>
    <message>
        <source>Irregular nodes</source>
        <translation>Irreguläre Knoten</translation>
    </message>
    <message>
        <source>Nodes inside faces where not four quads meet</source>
        <translation>Knoten im Innern von Flächen, in denen sich nicht vier Vierecke treffen</translation>
    </message>
    <message>
        <source>Watertight</source>
        <translation>Wasserdicht</translation>
    </message>
    <message>
        <source>Whether every mesh edge lies in exactly two elements</source>
        <translation>Ob jede Netzkante in genau zwei Elementen liegt</translation>
    </message>
    <message>
        <source>Lines of wires</source>
        <translation>Linien von Drähten</translation>
    </message>
    <message>
        <source>Line elements of edges that bound no face</source>
        <translation>Linienelemente von Kanten, die keine Fläche begrenzen</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>Pairs of parts that touch or cross, and how many meshes share no node</source>
        <translation>Paare von Teilen, die sich berühren oder kreuzen, und wie viele Netze keinen Knoten teilen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Of all stages</source>
        <translation>Aller Stufen</translation>
    </message>
    <message>
        <source>What keeps figures or faces from being here</source>
        <translation>Was Angaben oder Flächen hier fernhält</translation>
    </message>
    <message>
        <source>Figures of the mesh that the object has</source>
        <translation>Angaben zum Netz, das das Objekt hat</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>Time of this stage</source>
        <translation>Zeit dieser Stufe</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Nothing is meshed yet.</source>
        <translation>Noch ist nichts vernetzt.</translation>
    </message>
    <message>
        <source>min {}, mean {}</source>
        <translation>min {}, Mittel {}</translation>
    </message>
    <message>
        <source>{}; separate meshes: {}</source>
        <translation>{}; getrennte Netze: {}</translation>
    </message>
    <message>
        <source>no, {} free edges</source>
        <translation>nein, {} freie Kanten</translation>
    </message>
    <message>
        <source>; more than 'Most elements' allows, so choose longer elements or raise that</source>
        <translation>; mehr als „Höchstens Elemente“ erlaubt: Nehmen Sie längere Elemente oder erhöhen Sie es</translation>
    </message>
    <message>
        <source>; in a process of its own</source>
        <translation>; in einem eigenen Prozess</translation>
    </message>
    <message>
        <source>Whether the mesh fits the options and the shapes of its objects</source>
        <translation>Ob das Netz zu den Optionen und den Formen seiner Objekte passt</translation>
    </message>
    <message>
        <source>What meshing with these options comes to, or has come to</source>
        <translation>Was das Vernetzen mit diesen Optionen ergibt oder ergeben hat</translation>
    </message>
    <message>
        <source>Stage of the work, and how much of all work is done</source>
        <translation>Stufe der Arbeit, und wie viel der ganzen Arbeit getan ist</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Vernetzen</translation>
    </message>
    <message>
        <source>Meshes with these options, as Apply does; FreeCAD can be used meanwhile</source>
        <translation>Vernetzt mit diesen Optionen, wie Anwenden; FreeCAD bleibt dabei benutzbar</translation>
    </message>
    <message>
        <source>Stops meshing within a second; the mesh stays as it was</source>
        <translation>Hält das Vernetzen binnen einer Sekunde an; das Netz bleibt, wie es war</translation>
    </message>
    <message>
        <source>Selects it in the 3D view and brings it into sight</source>
        <translation>Wählt es in der 3D-Ansicht aus und bringt es ins Bild</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>What the last run has done and is doing</source>
        <translation>Was der letzte Lauf getan hat und gerade tut</translation>
    </message>
    <message>
        <source>Stages of the last run and their seconds, and what came of it</source>
        <translation>Schritte des letzten Laufs und ihre Sekunden, und was daraus geworden ist</translation>
    </message>
    <message>
        <source>Not meshed yet</source>
        <translation>Noch nicht vernetzt</translation>
    </message>
    <message>
        <source>The mesh is up to date</source>
        <translation>Das Netz ist aktuell</translation>
    </message>
    <message>
        <source>The mesh has holes: faces could not be meshed</source>
        <translation>Das Netz hat Löcher: Flächen ließen sich nicht vernetzen</translation>
    </message>
    <message>
        <source>Options or shapes have changed since meshing</source>
        <translation>Optionen oder Formen haben sich seit dem Vernetzen geändert</translation>
    </message>
    <message>
        <source>Meshing; FreeCAD can be used meanwhile</source>
        <translation>Vernetzt; FreeCAD bleibt dabei benutzbar</translation>
    </message>
    <message>
        <source>About {} element, up to {} of memory</source>
        <translation>Etwa {} Element, bis zu {} Speicher</translation>
    </message>
    <message>
        <source>About {} elements, up to {} of memory</source>
        <translation>Etwa {} Elemente, bis zu {} Speicher</translation>
    </message>
    <message>
        <source>The mesh has {} element</source>
        <translation>Das Netz hat {} Element</translation>
    </message>
    <message>
        <source>The mesh has {} elements</source>
        <translation>Das Netz hat {} Elemente</translation>
    </message>
    <message>
        <source>Options have been edited; Apply meshes with them</source>
        <translation>Optionen sind bearbeitet; Anwenden vernetzt mit ihnen</translation>
    </message>
    <message>
        <source>Show {}</source>
        <translation>{} zeigen</translation>
    </message>
    <message>
        <source>Show model</source>
        <translation>Modell zeigen</translation>
    </message>
    <message>
        <source>Shows what is meshed, to select from it</source>
        <translation>Zeigt, was vernetzt wird, um daraus auszuwählen</translation>
    </message>
    <message>
        <source>Show mesh</source>
        <translation>Netz zeigen</translation>
    </message>
    <message>
        <source>Shows the mesh</source>
        <translation>Zeigt das Netz</translation>
    </message>
    <message>
        <source>Target lengths of parts of the model; elements grow from there on</source>
        <translation>Ziellängen von Teilen des Modells; von dort an wachsen die Elemente</translation>
    </message>
    <message>
        <source>Add from selection</source>
        <translation>Aus der Auswahl</translation>
    </message>
    <message>
        <source>A shorter length on the faces, edges, vertices or objects that are selected in the 3D view, or on the faces under selected elements</source>
        <translation>Eine kürzere Länge auf den Flächen, Kanten, Punkten oder Objekten, die in der 3D-Ansicht gewählt sind, oder auf den Flächen unter gewählten Elementen</translation>
    </message>
    <message>
        <source>Deletes the chosen local sizes</source>
        <translation>Löscht die gewählten örtlichen Längen</translation>
    </message>
    <message>
        <source>Local sizes that are not shorter than the rest</source>
        <translation>Örtliche Längen, die nicht kürzer sind als der Rest</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Local sizes</source>
        <translation>Örtliche Längen</translation>
    </message>
    <message>
        <source>εr, μr of the medium there, whose wavelength counts</source>
        <translation>εr, μr des Mediums dort, dessen Wellenlänge zählt</translation>
    </message>
    <message>
        <source>Drop local sizes</source>
        <translation>Lokale Größen verwerfen</translation>
    </message>
    <message>
        <source>'{}' is no medium; write its εr, or εr and μr, such as 4, 1.</source>
        <translation>„{}“ ist kein Medium; schreiben Sie sein εr, oder εr und μr, etwa 4, 1.</translation>
    </message>
    <message>
        <source>Delete {}</source>
        <translation>{} löschen</translation>
    </message>
    <message>
        <source>No parts touch, and nothing is merged</source>
        <translation>Keine Teile berühren sich, und nichts wird verschmolzen</translation>
    </message>
    <message>
        <source>Target length: {} to {}</source>
        <translation>Ziellänge: {} bis {}</translation>
    </message>
    <message>
        <source>Shows on the model how long elements will be, where parts touch, and edges and faces that are merged with others</source>
        <translation>Zeigt am Modell, wie lang Elemente werden, wo Teile sich berühren, und Kanten und Flächen, die mit anderen verschmolzen werden</translation>
    </message>
    <message>
        <source>Target length everywhere: {}</source>
        <translation>Ziellänge überall: {}</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Looking...</source>
        <translation>Wird angesehen...</translation>
    </message>
    <message>
        <source>Short edges and small faces that are merged with others: {} and {}</source>
        <translation>Kurze Kanten und kleine Flächen, die mit anderen verschmolzen werden: {} und {}</translation>
    </message>
    <message>
        <source>{} pair of parts touches</source>
        <translation>{} Paar von Teilen berührt sich</translation>
    </message>
    <message>
        <source>{} pairs of parts touch</source>
        <translation>{} Paare von Teilen berühren sich</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Unknowns</source>
        <translation>Unbekannte</translation>
    </message>
    <message>
        <source>Full matrix</source>
        <translation>Volle Matrix</translation>
    </message>
    <message>
        <source>Least SJ</source>
        <translation>Kleinste SJ</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Of an electric-field integral equation on a conductor, with rooftops and RWG functions</source>
        <translation>Einer Integralgleichung des elektrischen Feldes auf einem Leiter, mit Rooftop- und RWG-Funktionen</translation>
    </message>
    <message>
        <source>Memory of the matrix of all these unknowns, in double precision</source>
        <translation>Speicher der Matrix all dieser Unbekannten, in doppelter Genauigkeit</translation>
    </message>
    <message>
        <source>Of meshing</source>
        <translation>Der Vernetzung</translation>
    </message>
    <message>
        <source>Smallest scaled Jacobian of all elements</source>
        <translation>Kleinste skalierte Jacobi-Determinante aller Elemente</translation>
    </message>
    <message>
        <source>What Check mesh finds, the worst first</source>
        <translation>Was Netz prüfen findet, das Schlimmste zuerst</translation>
    </message>
    <message>
        <source>Click on a row to see its mesh</source>
        <translation>Ein Klick auf eine Zeile zeigt ihr Netz</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Meshes a new series with these values, one step after the other; FreeCAD can be used meanwhile</source>
        <translation>Vernetzt eine neue Reihe mit diesen Werten, einen Schritt nach dem anderen; FreeCAD ist währenddessen benutzbar</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Meshes the steps of this series that have not been done, and those of before a change</source>
        <translation>Vernetzt die Schritte dieser Reihe, die noch nicht getan sind, und die von vor einer Änderung</translation>
    </message>
    <message>
        <source>Stops within a second; what is done stays</source>
        <translation>Hält innerhalb einer Sekunde an; was getan ist, bleibt</translation>
    </message>
    <message>
        <source>Save table...</source>
        <translation>Tabelle speichern...</translation>
    </message>
    <message>
        <source>Writes the table to a file, as CSV</source>
        <translation>Schreibt die Tabelle in eine Datei, als CSV</translation>
    </message>
    <message>
        <source>A series that runs goes on</source>
        <translation>Eine laufende Reihe geht weiter</translation>
    </message>
    <message>
        <source>Save table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>Not done</source>
        <translation>Nicht getan</translation>
    </message>
    <message>
        <source>Series of {}</source>
        <translation>Reihe von {}</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>The mesh object of '{}' is gone; make a series of another one.</source>
        <translation>Das Netzobjekt von '{}' gibt es nicht mehr; machen Sie eine Reihe eines anderen.</translation>
    </message>
    <message>
        <source>Step {} of '{}' has no mesh in the document; mesh it first.</source>
        <translation>Schritt {} von '{}' hat kein Netz im Dokument; vernetzen Sie ihn zuerst.</translation>
    </message>
    <message>
        <source>What differs from mesh to mesh; all else is as in the mesh object</source>
        <translation>Was sich von Netz zu Netz ändert; alles andere ist wie im Netzobjekt</translation>
    </message>
    <message>
        <source>Values with commas between them, or semicolons, such as 1 GHz, 2 GHz, 4 GHz</source>
        <translation>Werte, getrennt durch Kommas oder Strichpunkte, etwa 1 GHz, 2 GHz, 4 GHz</translation>
    </message>
    <message>
        <source>Vary</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>How many values</source>
        <translation>Wie viele Werte</translation>
    </message>
    <message>
        <source>By equal steps, or by equal factors</source>
        <translation>In gleichen Schritten oder mit gleichen Faktoren</translation>
    </message>
    <message>
        <source>Fill in</source>
        <translation>Eintragen</translation>
    </message>
    <message>
        <source>Writes the values of the range into the field above</source>
        <translation>Schreibt die Werte des Bereichs in das Feld darüber</translation>
    </message>
    <message>
        <source>A mesh object for each value, below the series in the tree</source>
        <translation>Ein Netzobjekt für jeden Wert, unter der Reihe im Baum</translation>
    </message>
    <message>
        <source>A file for each value and format, and the table as CSV, in the folder; nothing large in the document</source>
        <translation>Eine Datei für jeden Wert und jedes Format und die Tabelle als CSV, im Ordner; nichts Großes im Dokument</translation>
    </message>
    <message>
        <source>Where the files are written</source>
        <translation>Wohin die Dateien geschrieben werden</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Chooses the folder</source>
        <translation>Wählt den Ordner</translation>
    </message>
    <message>
        <source>values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Meshes in the document</source>
        <translation>Netze im Dokument</translation>
    </message>
    <message>
        <source>Files only</source>
        <translation>Nur Dateien</translation>
    </message>
    <message>
        <source>A series needs values; write some, such as 1 GHz, 2 GHz, 4 GHz.</source>
        <translation>Eine Reihe braucht Werte; schreiben Sie welche, etwa 1 GHz, 2 GHz, 4 GHz.</translation>
    </message>
    <message>
        <source>evenly</source>
        <translation>gleichmäßig</translation>
    </message>
    <message>
        <source>logarithmic</source>
        <translation>logarithmisch</translation>
    </message>
    <message>
        <source>No format is chosen for the files; choose one, or keep the meshes in the document.</source>
        <translation>Für die Dateien ist kein Format gewählt; wählen Sie eines oder behalten Sie die Netze im Dokument.</translation>
    </message>
    <message>
        <source>Building Paver</source>
        <translation>Paver wird kompiliert</translation>
    </message>
    <message>
        <source>All that the build needs is installed. It takes some minutes, in which FreeCAD can be used.</source>
        <translation>Alles, was zum Kompilieren nötig ist, ist installiert. Es dauert einige Minuten, in denen FreeCAD benutzt werden kann.</translation>
    </message>
    <message>
        <source>Set up Paver</source>
        <translation>Paver einrichten</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Erneut prüfen</translation>
    </message>
    <message>
        <source>Use a binary</source>
        <translation>Eine Binärdatei verwenden</translation>
    </message>
    <message>
        <source>Use it</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>Choose file...</source>
        <translation>Datei wählen...</translation>
    </message>
    <message>
        <source>Build it here</source>
        <translation>Hier kompilieren</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Kompilieren</translation>
    </message>
    <message>
        <source>Nothing can be meshed until then.</source>
        <translation>Bis dahin kann nichts vernetzt werden.</translation>
    </message>
    <message>
        <source>Building. This window may be closed meanwhile.</source>
        <translation>Paver wird kompiliert. Dieses Fenster kann inzwischen geschlossen werden.</translation>
    </message>
    <message>
        <source>Choose a binary of Paver</source>
        <translation>Binärdatei von Paver wählen</translation>
    </message>
    <message>
        <source>Nothing can be meshed without it. Use a binary, or build it here once.</source>
        <translation>Ohne den kompilierten Kern kann nichts vernetzt werden. Verwenden Sie eine Binärdatei, oder kompilieren Sie ihn hier einmal.</translation>
    </message>
    <message>
        <source>The build was stopped; Build goes on where it was.</source>
        <translation>Das Kompilieren wurde angehalten; Kompilieren macht dort weiter, wo es war.</translation>
    </message>
    <message>
        <source>The build failed; the end of the log says why.</source>
        <translation>Das Kompilieren ist fehlgeschlagen; das Ende des Protokolls sagt, warum.</translation>
    </message>
    <message>
        <source>A build here is for Python {} of the system, but this FreeCAD has Python {}. Use a binary for that one.</source>
        <translation>Hier würde für Python {} des Systems kompiliert, aber dieses FreeCAD hat Python {}. Verwenden Sie eine Binärdatei für dieses.</translation>
    </message>
    <message>
        <source>Binaries of Paver</source>
        <translation>Binärdateien von Paver</translation>
    </message>
    <message>
        <source>Unpacking {}</source>
        <translation>{} wird entpackt</translation>
    </message>
    <message>
        <source>Paver is ready.</source>
        <translation>Paver ist bereit.</translation>
    </message>
    <message>
        <source>Found: {}</source>
        <translation>Gefunden: {}</translation>
    </message>
    <message>
        <source>A binary is a file paver-{}-*.whl for the Python of this FreeCAD. There is none in FreeCAD's folders.</source>
        <translation>Eine Binärdatei ist eine Datei paver-{}-*.whl für das Python dieses FreeCAD. In den Ordnern von FreeCAD liegt keine.</translation>
    </message>
    <message>
        <source>Debian packages are missing for the build: {}. This command installs them, in a terminal:</source>
        <translation>Zum Kompilieren fehlen Debian-Pakete: {}. Dieser Befehl installiert sie, in einem Terminal:</translation>
    </message>
</context>
<context>
    <name>PaverPreferences</name>
    <message>
        <source>Meshes</source>
        <translation>Netze</translation>
    </message>
    <message>
        <source>New mesh objects</source>
        <translation>Neue Netzobjekte</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Frequency of new mesh objects; without one they get a length from the size of the model</source>
        <translation>Frequenz neuer Netzobjekte; ohne eine bekommen sie eine Länge nach der Größe des Modells</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Elements per wavelength</source>
        <translation>Elemente je Wellenlänge</translation>
    </message>
    <message>
        <source>Used with a frequency</source>
        <translation>Gilt bei einer Frequenz</translation>
    </message>
    <message>
        <source>Elements along the diagonal</source>
        <translation>Elemente entlang der Diagonale</translation>
    </message>
    <message>
        <source>Without a frequency: how many elements lie along the diagonal of the model</source>
        <translation>Ohne Frequenz: wie viele Elemente entlang der Diagonale des Modells liegen</translation>
    </message>
    <message>
        <source>Order of the elements</source>
        <translation>Ordnung der Elemente</translation>
    </message>
    <message>
        <source>Curved elements follow the surface</source>
        <translation>Gekrümmte Elemente folgen der Fläche</translation>
    </message>
    <message>
        <source>1 (straight)</source>
        <translation>1 (gerade)</translation>
    </message>
    <message>
        <source>2 (curved)</source>
        <translation>2 (gekrümmt)</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>All quads: triangles only where nothing else is possible</source>
        <translation>Nur Vierecke: Dreiecke nur, wo nichts anderes möglich ist</translation>
    </message>
    <message>
        <source>Quads and few triangles</source>
        <translation>Vierecke und wenige Dreiecke</translation>
    </message>
    <message>
        <source>All quads</source>
        <translation>Nur Vierecke</translation>
    </message>
    <message>
        <source>All triangles</source>
        <translation>Nur Dreiecke</translation>
    </message>
    <message>
        <source>Gradation</source>
        <translation>Gradation</translation>
    </message>
    <message>
        <source>Largest growth of the element size per unit of length</source>
        <translation>Größtes Wachstum der Elementgröße je Längeneinheit</translation>
    </message>
    <message>
        <source>From what number of elements on</source>
        <translation>Ab welcher Zahl von Elementen</translation>
    </message>
    <message>
        <source>Fill FemMesh up to</source>
        <translation>FemMesh füllen bis</translation>
    </message>
    <message>
        <source>Number of elements up to which FemMesh, which solvers use, is filled with each mesh; above on demand</source>
        <translation>Zahl der Elemente, bis zu der FemMesh, das Löser benutzen, mit jedem Netz gefüllt wird; darüber auf Verlangen</translation>
    </message>
    <message>
        <source>Own process from</source>
        <translation>Eigener Prozess ab</translation>
    </message>
    <message>
        <source>Number of predicted elements from which on meshing is done in a process of its own, whose crash FreeCAD survives</source>
        <translation>Zahl vorhergesagter Elemente, ab der in einem eigenen Prozess vernetzt wird, dessen Absturz FreeCAD übersteht</translation>
    </message>
</context>
<context>
    <name>Paver_About</name>
    <message>
        <source>About Paver</source>
        <translation>Über Paver</translation>
    </message>
    <message>
        <source>Shows versions in the report view, for a report of a fault</source>
        <translation>Zeigt Versionen im Ausgabefenster, für eine Fehlermeldung</translation>
    </message>
</context>
<context>
    <name>Paver_Check</name>
    <message>
        <source>Check mesh</source>
        <translation>Netz prüfen</translation>
    </message>
    <message>
        <source>Looks for faces that failed, folded and poor elements, free edges, triangles, long and short edges, says what it finds, and goes there</source>
        <translation>Sucht Flächen, die sich nicht vernetzen ließen, umgeschlagene und schlechte Elemente, freie Kanten, Dreiecke, lange und kurze Kanten, sagt, was es findet, und führt hin</translation>
    </message>
</context>
<context>
    <name>Paver_ColourCertificate</name>
    <message>
        <source>Colours by certificate</source>
        <translation>Farben nach Zertifikat</translation>
    </message>
</context>
<context>
    <name>Paver_ColourFace</name>
    <message>
        <source>Colours by source face</source>
        <translation>Farben nach Ursprungsfläche</translation>
    </message>
</context>
<context>
    <name>Paver_ColourLength</name>
    <message>
        <source>Colours by edge length / target</source>
        <translation>Farben nach Kantenlänge / Ziellänge</translation>
    </message>
</context>
<context>
    <name>Paver_ColourLocalLength</name>
    <message>
        <source>Colours by edge length / local target</source>
        <translation>Farben nach Kantenlänge / örtlicher Ziellänge</translation>
    </message>
</context>
<context>
    <name>Paver_ColourNone</name>
    <message>
        <source>One colour</source>
        <translation>Eine Farbe</translation>
    </message>
</context>
<context>
    <name>Paver_ColourQuality</name>
    <message>
        <source>Colours by scaled Jacobian</source>
        <translation>Farben nach skalierter Jacobi-Determinante</translation>
    </message>
</context>
<context>
    <name>Paver_ColourType</name>
    <message>
        <source>Colours by element type</source>
        <translation>Farben nach Elementart</translation>
    </message>
</context>
<context>
    <name>Paver_Colours</name>
    <message>
        <source>Colours of the elements</source>
        <translation>Farben der Elemente</translation>
    </message>
    <message>
        <source>What the colours of the elements tell</source>
        <translation>Was die Farben der Elemente bedeuten</translation>
    </message>
</context>
<context>
    <name>Paver_CreateMesh</name>
    <message>
        <source>Create mesh</source>
        <translation>Netz anlegen</translation>
    </message>
    <message>
        <source>Makes a mesh object for the selected objects and opens its panel</source>
        <translation>Legt für die ausgewählten Objekte ein Netzobjekt an und öffnet sein Aufgabenfenster</translation>
    </message>
</context>
<context>
    <name>Paver_Export</name>
    <message>
        <source>Export mesh...</source>
        <translation>Netz exportieren ...</translation>
    </message>
    <message>
        <source>Writes the mesh to a file: Gmsh and VTK with all nodes, and the formats of the FEM workbench</source>
        <translation>Schreibt das Netz in eine Datei: Gmsh und VTK mit allen Knoten, und die Formate des FEM-Arbeitsbereichs</translation>
    </message>
</context>
<context>
    <name>Paver_FillFemMesh</name>
    <message>
        <source>Fill FEM mesh</source>
        <translation>FEM-Netz füllen</translation>
    </message>
    <message>
        <source>Fills FemMesh of the selected mesh objects, whatever the size, for solvers and exports of the FEM workbench</source>
        <translation>Füllt FemMesh der ausgewählten Netzobjekte, wie groß sie auch sind, für Löser und Exporte des FEM-Arbeitsbereichs</translation>
    </message>
</context>
<context>
    <name>Paver_Help</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>How to make a mesh, what the options mean, what to do when something goes wrong</source>
        <translation>Wie ein Netz entsteht, was die Optionen bedeuten, was zu tun ist, wenn etwas schiefgeht</translation>
    </message>
</context>
<context>
    <name>Paver_HideFaces</name>
    <message>
        <source>Hide faces of the selection</source>
        <translation>Flächen der Auswahl ausblenden</translation>
    </message>
</context>
<context>
    <name>Paver_Import</name>
    <message>
        <source>Import mesh...</source>
        <translation>Netz importieren ...</translation>
    </message>
    <message>
        <source>Makes a mesh object of a file: Gmsh, VTK, and the formats of the FEM workbench</source>
        <translation>Macht aus einer Datei ein Netzobjekt: Gmsh, VTK, und die Formate des FEM-Arbeitsbereichs</translation>
    </message>
</context>
<context>
    <name>Paver_Isolate</name>
    <message>
        <source>Parts of the mesh alone</source>
        <translation>Teile des Netzes allein</translation>
    </message>
    <message>
        <source>Hides faces, or shows only some elements; what is hidden is not picked</source>
        <translation>Blendet Flächen aus oder zeigt nur einige Elemente; was ausgeblendet ist, lässt sich nicht anklicken</translation>
    </message>
</context>
<context>
    <name>Paver_Medium</name>
    <message>
        <source>Medium</source>
        <translation>Medium</translation>
    </message>
    <message>
        <source>Says what the selected solids are made of: sets the target length there, and is written to files</source>
        <translation>Sagt, woraus die gewählten Volumenkörper bestehen: bestimmt die Ziellänge dort und steht in Dateien</translation>
    </message>
</context>
<context>
    <name>Paver_Mesh</name>
    <message>
        <source>Mesh</source>
        <translation>Vernetzen</translation>
    </message>
    <message>
        <source>Meshes the selected mesh objects with their options, while FreeCAD can be used; double click on one for its panel</source>
        <translation>Vernetzt die ausgewählten Netzobjekte mit ihren Optionen, während FreeCAD benutzbar bleibt; ein Doppelklick auf eines öffnet sein Aufgabenfenster</translation>
    </message>
</context>
<context>
    <name>Paver_OnlyFaces</name>
    <message>
        <source>Only faces of the selection</source>
        <translation>Nur Flächen der Auswahl</translation>
    </message>
</context>
<context>
    <name>Paver_OnlyFreeEdges</name>
    <message>
        <source>Only free edges</source>
        <translation>Nur freie Kanten</translation>
    </message>
</context>
<context>
    <name>Paver_OnlySelected</name>
    <message>
        <source>Only selected elements</source>
        <translation>Nur ausgewählte Elemente</translation>
    </message>
</context>
<context>
    <name>Paver_OnlyWorst</name>
    <message>
        <source>Only the worst elements</source>
        <translation>Nur die schlechtesten Elemente</translation>
    </message>
</context>
<context>
    <name>Paver_Port</name>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Gives the selected faces, edges and vertices a name in the mesh and its files, for feeds and loads</source>
        <translation>Gibt den gewählten Flächen, Kanten und Punkten einen Namen im Netz und in seinen Dateien, für Speisungen und Lasten</translation>
    </message>
</context>
<context>
    <name>Paver_Preferences</name>
    <message>
        <source>Preferences...</source>
        <translation>Einstellungen ...</translation>
    </message>
    <message>
        <source>What new mesh objects start with, and from what size on work is done differently</source>
        <translation>Womit neue Netzobjekte beginnen, und ab welcher Größe anders gearbeitet wird</translation>
    </message>
</context>
<context>
    <name>Paver_Refine</name>
    <message>
        <source>Refine</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Shorter elements on the selected faces, edges, vertices or solids of what is meshed, or on the faces under selected elements, and around them; opens a panel for the length</source>
        <translation>Kürzere Elemente auf den gewählten Flächen, Kanten, Punkten oder Körpern dessen, was vernetzt wird, oder auf den Flächen unter gewählten Elementen, und um sie herum; öffnet ein Fenster für die Länge</translation>
    </message>
</context>
<context>
    <name>Paver_Series</name>
    <message>
        <source>Series...</source>
        <translation>Reihe...</translation>
    </message>
    <message>
        <source>Meshes for several frequencies, elements per wavelength or target lengths, one after the other, and a table of elements, unknowns, memory and quality</source>
        <translation>Netze für mehrere Frequenzen, Elemente je Wellenlänge oder Ziellängen, eines nach dem anderen, und eine Tabelle von Elementen, Unbekannten, Speicher und Güte</translation>
    </message>
</context>
<context>
    <name>Paver_ShowEverything</name>
    <message>
        <source>Everything again</source>
        <translation>Wieder alles</translation>
    </message>
</context>
<context>
    <name>Paver_ShowFreeEdges</name>
    <message>
        <source>Free edges</source>
        <translation>Freie Kanten</translation>
    </message>
    <message>
        <source>Marks mesh edges with one element only, and those with more than two, or no longer</source>
        <translation>Hebt Netzkanten mit nur einem Element und solche mit mehr als zweien hervor, oder nicht mehr</translation>
    </message>
</context>
<context>
    <name>Paver_ShowNormals</name>
    <message>
        <source>Normals</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>Shows the outward normal of every element, or no longer</source>
        <translation>Zeigt die Außennormale jedes Elements, oder nicht mehr</translation>
    </message>
</context>
<context>
    <name>Paver_ShowTriangles</name>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Marks the triangles, or no longer</source>
        <translation>Hebt die Dreiecke hervor, oder nicht mehr</translation>
    </message>
</context>
<context>
    <name>Paver_ShowWorst</name>
    <message>
        <source>Worst elements</source>
        <translation>Schlechteste Elemente</translation>
    </message>
    <message>
        <source>Marks the ten elements with the least scaled Jacobian, or no longer</source>
        <translation>Hebt die zehn Elemente mit der kleinsten skalierten Jacobi-Determinante hervor, oder nicht mehr</translation>
    </message>
</context>
<context>
    <name>Paver_Shrink</name>
    <message>
        <source>Shrink elements</source>
        <translation>Elemente verkleinern</translation>
    </message>
    <message>
        <source>Draws every element smaller, so that each is seen alone, or whole again</source>
        <translation>Zeichnet jedes Element kleiner, sodass es für sich zu sehen ist, oder wieder ganz</translation>
    </message>
</context>
<context>
    <name>Paver_Statistics</name>
    <message>
        <source>Statistics</source>
        <translation>Statistik</translation>
    </message>
    <message>
        <source>Lengths, areas and quality in millimetres and wavelengths, histograms, unknowns and matrix memory</source>
        <translation>Längen, Flächeninhalte und Güte in Millimetern und Wellenlängen, Histogramme, Unbekannte und Matrixspeicher</translation>
    </message>
</context>
<context>
    <name>Paver_Wire</name>
    <message>
        <source>Wire</source>
        <translation>Draht</translation>
    </message>
    <message>
        <source>Meshes the selected edges or sketches as a thin wire, joined to the faces that it ends on</source>
        <translation>Vernetzt die gewählten Kanten oder Skizzen als dünnen Draht, verbunden mit den Flächen, auf denen er endet</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Paver view</source>
        <translation>Paver-Ansicht</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Paver</source>
        <translation>Paver</translation>
    </message>
    <message>
        <source>&amp;Paver</source>
        <translation>&amp;Paver</translation>
    </message>
</context>
</TS>
