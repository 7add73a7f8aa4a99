"use strict";(()=>{var zt,kg,OM,vs,of,cc,Og,ac,Bg,lf,af,BM,$a=Symbol.for("pv"),uc={},hc=[],VM=/^m(i|n|o|s|text|space)$/,cf=Array.isArray,uf=hc.slice,Ys=Object.assign;function qs(n){n&&n.parentNode&&n.remove()}function Vg(n,e,t){var i,r,s,o={},a=arguments.length;for(s in e)s=="key"?i=e[s]:s=="ref"&&typeof n!="function"?r=e[s]:o[s]=e[s];return a>2&&(o.children=a>3?uf.call(arguments,2):t),Wa(n,o,i,r,null)}function Wa(n,e,t,i,r){var s={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:$a,__v:r||++kg,__i:-1,__u:0};return!r&&zt.vnode&&zt.vnode(s),s}function Oe(n){return n.children}function No(n,e){this.props=n,this.context=e,this.__g=0}function bs(n,e){if(e==null)return n.__&&bs(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:bs(n)}function zM(n){var e,t=n.__v,i=t.__e,r=[],s=[],o=n.__P;o&&((e=Ys({constructor:$a},t)).__v=t.__v+1,zt.vnode&&zt.vnode(e),hf(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,r,i||bs(t),32&t.__u,s),e.__v=t.__v,e.__.__k[e.__i]=e,Xg(r,e,s),t.__=t.__e=null,e.__e!=i&&zg(e))}function zg(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),zg(n)}function Fg(n){(8&n.__g||(n.__g|=8,vs.push(n),cc++))&&of==zt.debounceRendering||((of=zt.debounceRendering)||queueMicrotask)(Hg)}function Hg(){try{for(var n,e=1;vs.length;)vs.length>e&&vs.sort(Og),n=vs.shift(),e=vs.length,8&n.__g&&zM(n)}finally{(cc=vs.length)&&(of||queueMicrotask)(Hg)}}function Gg(n,e,t,i,r,s,o,a,l,c,h){var f,d,p,m,x,_,g=i.__k||hc,v=e.length;for(l=HM(t,e,g,l,v),f=0;f<v;f++)(p=t.__k[f])!=null&&(d=~p.__i&&g[p.__i]||uc,p.__i=f,_=hf(n,p,d,r,s,o,a,l,c,h),m=p.__e,(d.ref!=p.ref||8&d.__u)&&(d.ref&&df(d.ref,null,p,d),p.ref&&h.push(p.ref,p.__c||m,p)),x=x||m,4&p.__u?(l=Wg(p,l,n,!d.__v),d.__e&&(d.__e=null)):typeof p.type=="function"&&_!==void 0?l=_:m&&(l=m.nextSibling),p.__u&=-21);return t.__e=x,l}function HM(n,e,t,i,r){var s,o,a,l,c,h,f,d,p,m=t.length,x=m,_=0,g=0,v=n.__k=Array(r);for(s=0;s<r;s++)(o=e[s])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=v[s]=Wa(null,o):cf(o)?o=v[s]=Wa(Oe,{children:o}):o.constructor===$a&&o.__b?o=v[s]=Wa(o.type,o.props,o.key,o.ref,o.__v):v[s]=o,l=s+_,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=GM(o,t,l,x))&&(x--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?_--:c==l+1?_++:c!=l&&(c>l?_--:_++,g=1)):(~c||(r>m?_--:r<m&&_++),typeof o.type!="function"&&(o.__u|=4))):v[s]=null;if(g){for(h=[],f=[],s=0;s<r;s++)if((o=v[s])&&16&o.__u){for(_=0,d=h.length;_<d;)h[p=_+d>>1]<o.__i?_=p+1:d=p;h[_]=o.__i,f[s]=_+1}for(_=h.length;s--;)f[s]&&(f[s]==_?_--:v[s].__u|=4)}if(x)for(s=0;s<m;s++)!(a=t[s])||2&a.__u||(a.__e==i&&(i=bs(a)),ff(a,a));return i}function Wg(n,e,t,i){var r,s,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(r=n.__k)for(s=0;s<r.length;s++)r[s]&&(r[s].__=n,e=Wg(r[s],e,t,!1));return e}for(e&&!e.parentNode&&(e=bs(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function GM(n,e,t,i){var r,s=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&s==null||l&&s==a.key&&o==a.type)return t;if(i>(l?1:0)){for(r=t-1;r>=0;r--)if((a=e[r])&&!(2&a.__u)&&s==a.key&&o==a.type)return r;for(r=t+1;r<e.length;r++)if((a=e[r])&&!(2&a.__u)&&s==a.key&&o==a.type)return r}return-1}function Ug(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function oc(n,e,t,i,r){var s,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Ug(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Ug(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=af[e]||(af[e]=WM(e)),(n.__a||(n.__a={}))[e]=lf,s=e!=(e=e.replace(Bg,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,s):n.removeEventListener(e,o,s));else{if(r=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function WM(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[ac]==null)e[ac]=lf++;else if(e[ac]<this.__a[n])return;return t(zt.event?zt.event(e):e)}}}function hf(n,e,t,i,r,s,o,a,l,c){var h,f,d,p,m,x,_,g,v,E,M,I,C,b,A,G,F,D,H=e.type;if(e.constructor!==$a)return null;128&t.__u&&(l=32&t.__u,h=t.__c.__z)&&(e.__u|=l,f=s=[],h.nodeType==8?a=lc(h,s):s.push(h),a=s[0]||a),(h=zt.__b)&&h(e);e:if(typeof H=="function"){d=o.length;try{if(g=e.props,v=(h=H.prototype)&&h.render,E=(h=H.contextType)&&i[h.__c],M=h?E?E.props.value:h.__:i,(p=t.__c)?(e.__c=p,2&p.__g&&(p.__g|=1)):(v?e.__c=p=new H(g,M):(e.__c=p=new No(g,M),p.constructor=H,p.render=XM),E&&E.sub(p),p.state||(p.state={}),p.__n=i,p.__g|=8,p.__h=[],p.__k=[]),v&&(p.__s||(p.__s=p.state),H.getDerivedStateFromProps&&(p.__s==p.state&&(p.__s=Ys({},p.__s)),Ys(p.__s,H.getDerivedStateFromProps(g,p.__s)))),m=p.props,x=p.state,p.__v=e,t.__c){if(g!==m&&v&&!H.getDerivedStateFromProps&&p.componentWillReceiveProps&&p.componentWillReceiveProps(g,M),e.__v==t.__v&&!(8&p.__g)||!(4&p.__g)&&p.shouldComponentUpdate&&p.shouldComponentUpdate(g,p.__s,M)===!1){e.__v!=t.__v&&(p.props=g,p.state=p.__s,p.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(V){V&&(V.__=e)}),hc.push.apply(p.__h,p.__k),p.__k=[],p.__h.length&&o.push(p),a=bs(t);break e}p.componentWillUpdate&&p.componentWillUpdate(g,p.__s,M),v&&p.componentDidUpdate&&p.__h.push(function(){p.componentDidUpdate(m,x,_)})}else v&&!H.getDerivedStateFromProps&&p.componentWillMount&&p.componentWillMount(),v&&p.componentDidMount&&p.__h.push(p.componentDidMount);p.context=M,p.props=g,p.__P=n,p.__g&=-5,I=zt.__r,C=v?25:0;do p.__g&=-9,I&&I(e),h=p.render(p.props,p.state=p.__s,p.context);while(8&p.__g&&++C<25);v&&(hc.push.apply(p.__h,p.__k),p.__k=[]),p.state=p.__s,p.getChildContext&&(i=Ys({},i,p.getChildContext())),v&&t.__c&&p.getSnapshotBeforeUpdate&&(_=p.getSnapshotBeforeUpdate(m,x)),b=h&&h.type===Oe&&h.key==null?h.props.children:h,g.__P&&(h=a,r=(n=g.__P).namespaceURI,l=s=null,t.props&&t.props.__P!=n&&(t.__k.some(function(V){V&&ff(V,V)}),t.__k=null),a=t.__k?bs(t,0):null),a=Gg(n,cf(b)?b:[b],e,t,i,r,s,o,a,l,c),g.__P&&(e.__e=null,a=h),e.__u&=-161,f&&f.some(qs),p.__h.length&&o.push(p),1&p.__g&&(p.__g&=-4)}catch(V){if(o.length=d,e.__v=null,l||s)if(V&&V.then){if(e.__u|=128|l,s){for(~(F=s.indexOf(a||void 0))||(F=s.length);(D=s[F-1])&&D.nodeType==8;)F--;for(;F<s.length;F++)if(D=s[F])if(s[F]=null,A){if(D==G)break}else{if(D.nodeType!=8)break;D.data.startsWith("$s")&&(G=lc(A=D))}}if(!A){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;A=a}(h=lc(A=e.__c.__z||(e.__c.__z=A)))?(e.__e=A,a=h):e.__e=a,a=a&&a.nextSibling}else s&&s.some(qs);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),V&&V.then||$g(e),zt.__e(V,e,t)}}else a=e.__e=$M(t.__e,e,t,i,r,s,o,l,c,n);return(h=zt.diffed)&&h(e),a}function lc(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function $g(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some($g))}function Xg(n,e,t){for(var i=0;i<t.length;)df(t[i++],t[i++],t[i++]);zt.__c&&zt.__c(e,n),n.some(function(r){try{n=r.__h,r.__h=[],n.some(function(s){s.call(r)})}catch(s){zt.__e(s,r.__v)}})}function $M(n,e,t,i,r,s,o,a,l,c){var h,f,d,p,m,x,_,g,v=t.props||uc,E=e.props,M=e.type;if(M=="svg"?r="http://www.w3.org/2000/svg":M=="math"?r="http://www.w3.org/1998/Math/MathML":r||(r="http://www.w3.org/1999/xhtml"),s){for(h=0;h<s.length;h++)if((m=s[h])&&(M?m.localName==M:m.nodeType==3)){n=m,s[h]=null;break}}if(!n){if(g=c.ownerDocument||document,!M)return g.createTextNode(E);n=g.createElementNS(r,M,E.is?E:c),a&&(zt.__m&&zt.__m(e,s),a=!1),s=null}if(M){if(c=M=="template"&&n.content||n,s=M=="textarea"&&E.defaultValue!=null?null:s&&uf.call(c.childNodes),!a&&s)for(v={},h=0;h<n.attributes.length;h++)v[(m=n.attributes[h]).name]=m.value;for(h in v)m=v[h],h=="dangerouslySetInnerHTML"?d=m:h=="children"||h in E||h=="value"&&"defaultValue"in E||h=="checked"&&"defaultChecked"in E||oc(n,h,null,m,r);for(h in E)m=E[h],h=="children"?p=m:h=="dangerouslySetInnerHTML"?f=m:h=="value"?x=m:h=="checked"?_=m:a&&typeof m!="function"||v[h]===m||oc(n,h,m,v[h],r);f?(a||d&&(f.__html==d.__html||f.__html==n.innerHTML)||(n.innerHTML=f.__html),e.__k=[]):(d&&(n.textContent=""),(M=="foreignObject"||r=="http://www.w3.org/1998/Math/MathML"&&VM.test(M))&&(r="http://www.w3.org/1999/xhtml"),Gg(c,cf(p)?p:[p],e,t,i,r,s,o,s?s[0]:t.__k&&bs(t,0),a,l),s&&s.some(qs)),a&&M!="textarea"||(h="value",M=="progress"&&x==null?n.removeAttribute(h):x==null||x===n[h]&&(M!="progress"||x)||oc(n,h,x,v[h],r),h="checked",_!=null&&_!=n[h]&&oc(n,h,_,v[h],r))}else v===E||a&&n.data==E||(n.data=E);return n}function df(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(r){zt.__e(r,t)}}function ff(n,e,t){var i,r,s,o;if(zt.unmount&&zt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||df(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){zt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&ff(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(r=lc(i,s=[]))&&(i==n.__e&&s.some(qs),qs(r),qs(i)),t||qs(n.__e),n.__e=n.__c=n.__=null}function XM(n,e,t){return this.constructor(n,t)}function Xa(n,e){var t,i,r,s;zt.__&&zt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Wa(Oe,{children:[n]}),r=[],s=[],hf(e,e.__k,i||uc,uc,e.namespaceURI,i?null:e.firstChild?uf.call(e.childNodes):null,r,i?i.__e:e.firstChild,t,s),Xg(r,e.__k,s),e.__k.props.children=null}zt={__e:function(n,e,t,i){for(var r,s,o;e=e.__;)if((r=e.__c)&&!(1&r.__g)){r.__g|=4;try{if((o=(s=r.constructor)&&s.getDerivedStateFromError)&&r.setState(s.getDerivedStateFromError(n)),r.componentDidCatch&&(r.componentDidCatch(n,i||{}),o=1),o&&8&r.__g)return void(r.__g|=2)}catch(a){n=a}}throw cc=0,n}},kg=0,OM=function(n){return n!=null&&n.constructor===$a},No.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Ys({},this.state)),typeof n=="function"&&(n=n(Ys({},t),this.props)),n&&(Ys(t,n),this.__v&&(e&&this.__k.push(e),Fg(this)))},No.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Fg(this))},No.prototype.render=Oe,vs=[],cc=0,Og=function(n,e){return n.__v.__b-e.__v.__b},ac=Symbol(),Bg=/(PointerCapture)$|Capture$/i,lf=0,af={},BM=0;async function qg(n){let e=document.getElementById(`block-${n}`)?.textContent;if(e==null)throw new Error(`the report has no block ${n}`);let t=Uint8Array.from(atob(e.trim()),r=>r.charCodeAt(0)),i=new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip"));return new Uint8Array(await new Response(i).arrayBuffer())}async function Yg(n){return JSON.parse(new TextDecoder().decode(await qg(n)))}var dc=class n{constructor(e){this.bytes=e;let t=new DataView(e.buffer,e.byteOffset).getUint32(0,!0);this.trace=JSON.parse(new TextDecoder().decode(e.subarray(4,4+t))),this.start=Math.ceil((4+t)/4)*4}bytes;trace;start;static async of(e){return new n(await qg(e))}floats(e){let t=this.bytes.byteOffset+this.start+e.offset;return new Float32Array(this.bytes.buffer.slice(t,t+4*e.count))}steps(e){let t=e.min.length,i=new Float32Array(e.frames*t),r=this.start+e.offset;for(let s=0;s<t;++s){let o=0;for(let a=0;a<e.frames;++a){let l=0,c=0,h;do h=this.bytes[r++]??0,l|=(h&127)<<c,c+=7;while(h&128);o+=l>>>1^-(l&1),i[a*t+s]=o===0?NaN:e.min[s]+e.step[s]*(o-1)}}return i}frames(e){return{time:this.floats(e.time),position:this.steps(e.position),orientation:this.steps(e.orientation)}}};var Jg="cylon-theme",pf=new Set,Zg=matchMedia("(prefers-color-scheme: dark)"),fc=qM(),mf=!1;function qM(){try{let n=localStorage.getItem(Jg);return n==="light"||n==="dark"?n:"auto"}catch{return"auto"}}function qa(){let n=!mf&&(fc==="dark"||fc==="auto"&&Zg.matches);document.documentElement.dataset.theme=n?"dark":"light";for(let e of pf)e()}function Kg(){return fc}function jg(n){fc=n;try{localStorage.setItem(Jg,n)}catch{}qa()}function Fo(n){return pf.add(n),()=>pf.delete(n)}function jn(n){return getComputedStyle(document.documentElement).getPropertyValue(n).trim()}function pc(){Zg.addEventListener("change",qa),addEventListener("beforeprint",()=>(mf=!0,qa())),addEventListener("afterprint",()=>(mf=!1,qa())),qa()}var Uo,Tn,gf,Qg,_f=Object.is,Ja=0,l0=[],xf=[],_n=zt,e0=_n.__b,t0=_n.__r,n0=_n.diffed,i0=_n.__c,r0=_n.unmount,s0=_n.__;function mc(n,e){_n.__h&&_n.__h(Tn,n,Ja||e),Ja=0;var t=Tn.__H||(Tn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function et(n){return Ja=1,YM(u0,n)}function YM(n,e,t){var i=mc(Uo++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):u0(void 0,e),function(s){var o=(i.__N||i.__)[0],a=i.t(o,s);_f(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=Tn,!Tn.__f)){Tn.__f=!0;var r=Tn.shouldComponentUpdate;Tn.shouldComponentUpdate=function(s,o,a){var l=this.__H;if(!l)return!0;var c=!1,h=this.props!=s;if(l.__.some(function(d){d.__N&&(c=!0,_f(d.__[0],d.__N[0])||(h=!0))}),r){var f=r.call(this,s,o,a);return c?f||h:f}return!c||h}}return i.__}function Rt(n,e){var t=mc(Uo++,3);!_n.__s&&vf(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,Tn.__H.__h.push(t))}function wi(n,e){var t=mc(Uo++,4);!_n.__s&&vf(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,Tn.__h.push(t))}function Ht(n){return Ja=5,Ue(function(){return{current:n}},[])}function Ue(n,e){var t=mc(Uo++,7);return vf(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function c0(n,e){return Ja=8,Ue(function(){return n},e)}function JM(){var n;do{for(;n=xf.shift();)try{Ya(n)}catch(t){_n.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=l0.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Ya),e.__h.some(yf),e.__h=[]}catch(t){e.__h=[],_n.__e(t,n.__v)}}}while(xf.length)}_n.__b=function(n){Tn=null,e0&&e0(n)},_n.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),s0&&s0(n,e)},_n.__r=function(n){t0&&t0(n),Uo=0;var e=(Tn=n.__c).__H;e&&(gf==Tn?Tn.__h=[]:(e.__h.some(Ya),e.__h.some(yf),Uo=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),gf=Tn},_n.diffed=function(n){n0&&n0(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&a0(l0.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),gf=Tn=null},_n.__c=function(n,e){e.some(function(t){try{t.__h.some(Ya),t.__h=t.__h.filter(function(i){return!i.__||yf(i)})}catch(i){t.__h=[function(){throw i}]}}),i0&&i0(n,e)},_n.unmount=function(n){r0&&r0(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(r){try{if(r.__P&&r.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}r.__P=t,a0(xf.push(r))}else Ya(r)}catch(s){e=s}}),i.__H=void 0,e&&_n.__e(e,i.__v))};var o0=typeof requestAnimationFrame=="function";function ZM(n){var e,t=function(){clearTimeout(i),o0&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);o0&&(e=requestAnimationFrame(t))}function a0(n){n!=1&&Qg==_n.requestAnimationFrame||((Qg=_n.requestAnimationFrame)||ZM)(JM)}function Ya(n){var e=Tn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),Tn=e}function yf(n){var e=Tn;n.__c=n.__(),Tn=e}function vf(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!_f(t,n[i])})}function u0(n,e){return typeof e=="function"?e(n):e}function bf(n){return Object.fromEntries(new URLSearchParams(n.replace(/^#/,"")))}function gc(n){let e=Object.entries(n).filter(([,t])=>t!=="");return`#${new URLSearchParams(e).toString()}`}var Sf=new Set,or={};function h0(){for(let n of Sf)n(or)}function d0(){or=bf(location.hash),addEventListener("hashchange",()=>{gc(bf(location.hash))!==gc(or)&&(or=bf(location.hash),h0())})}function Js(){return or}function an(n,e=!1){or=Object.fromEntries(Object.entries({...or,...n}).filter(([,i])=>i!==""));let t=gc(or);try{e?history.pushState(null,"",t):history.replaceState(null,"",t)}catch{location.hash=t}h0()}function An(){let[n,e]=et(or);return wi(()=>(Sf.add(e),e(or),()=>{Sf.delete(e)}),[]),n}var f0={cell:"",engine:"",scheme:"",dt:"",other:"",claims:"",t:""};function Cr(n){return{...f0,cell:n.scenario,engine:n.engine,scheme:n.integrator,dt:n.dt}}function Ss(n){return{...f0,section:n}}function Qn(n){return gc({...or,...n})}function p0(n){return n.cell===void 0?null:{scenario:n.cell,engine:n.engine??"",integrator:n.scheme??"",dt:n.dt??""}}var KM=[[1,""],[.001,"m"],[1e-6,"\xB5"],[1e-9,"n"],[1e-12,"p"]];function jM(n){return Math.abs(n)<1e3?Number(n.toPrecision(3)):Math.round(n)}function Ln(n){if(n==null||!Number.isFinite(n))return"not measured";let[e,t]=KM.find(([i])=>Math.abs(n)>=.1*i)??[1e-12,"p"];return n===0?"0 s":`${jM(n/e)} ${t}s`}function li(n){let e="(\\d+(?:\\.\\d*)?|\\.\\d+)(?:e[-+]?\\d+)?";if(!new RegExp(`^${e}(?:/${e})?$`,"i").test(n))return n;let[t=0,i=1]=n.split("/").map(Number),r=t/i;if(!Number.isFinite(r))return n;let s=Number(r.toPrecision(3));return Math.abs(s-r)<=1e-12*r?Ln(r):`${n} s`}function Zs(n){let e=Math.round(n*10)/10;return(e<0?"-":"+")+Math.abs(e).toFixed(1)}function ko(n){return n>=99?"exact":Zs(n)}function _c(n){return n>=99?"exact":`${Zs(n)} digits`}function ge(n,e=4){if(n==null)return"not finite";if(!Number.isFinite(n))return Number.isNaN(n)?"NaN":n>0?"inf":"-inf";if(n===0)return"0";let[t="0",i="0"]=n.toExponential(e-1).split("e"),r=Number(i);return r<-4||r>=e?`${m0(t)}e${r}`:m0(n.toFixed(Math.max(0,e-1-r)))}function m0(n){return n.includes(".")?n.replace(/\.?0+$/,""):n}function Gn(n,e,t=4){let i=typeof n=="string"?n:ge(n,t);return e?`${i} ${e}`:i}function xc(n){return n.interval?Gn(`${ge(n.measured)} [${ge(n.interval[0])}, ${ge(n.interval[1])}]`,n.unit):Gn(n.measured,n.unit)}function Pt(n,e,t=`${e}s`){return`${n} ${n===1?e:t}`}var Yn={pass:{glyph:"\u2713",meaning:"within tolerance",tone:"pass"},unsupported:{glyph:"\u2013",meaning:"the engine refuses the scene",tone:"unsupported"},undecided:{glyph:"?",meaning:"undecided: the tolerance lies within the uncertainty, or theory bounds nothing",tone:"undecided"},"low-quality":{glyph:"~",meaning:"within ten times the tolerance",tone:"low-quality"},fail:{glyph:"\u2717",meaning:"beyond that",tone:"fail"},"non-finite":{glyph:"\u221E non-finite",meaning:"NaN or infinite",tone:"broken"},timeout:{glyph:"\u25F7 timeout",meaning:"no end before the deadline",tone:"broken"},crash:{glyph:"\u2620\uFE0E crash",meaning:"the worker died",tone:"broken"},protocol:{glyph:"\u203D protocol",meaning:"the worker sent garbage",tone:"broken"}},Mf=Object.keys(Yn);function Xi(n){return Mf.indexOf(n)}function xn(n){return n==="pass"||n==="low-quality"||n==="fail"||n==="undecided"}function wf(n){return xn(n)||n==="non-finite"}function ar(n,e){return n===null||e===null||!Number.isFinite(n)?-99:n===0?99:e===0?-99:Math.min(99,Math.max(-99,Math.log10(e/n)))}function lr(n){return!n.as_expected}function Za(n,e){let t=Xi(n.status)-Xi(e.status);return t!==0||!xn(n.status)?t:ar(e.measured,e.allowed)-ar(n.measured,n.allowed)}function yc(n){return[...n].sort((e,t)=>Number(lr(t))-Number(lr(e))||Za(t,e))}var QM=Symbol.for("pv"),ew=0;function u(n,e,t,i,r,s){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:QM,__v:--ew,__i:-1,__u:0};return(r||s)&&(c.__source=r,c.__self=s),zt.vnode&&zt.vnode(c),c}function cr({status:n,word:e=!0}){let{glyph:t,tone:i}=Yn[n],r=t.includes(" ");return u("span",{class:`status ${i}`,children:e&&!r?`${t} ${n}`:t})}function Yr({text:n="!"}){return u("strong",{class:"differs",children:[u("span",{"aria-hidden":"true",children:n}),u("span",{class:"unseen",children:"differs from expected.toml"})]})}function g0(n,e,t){let i=xn(n)&&e!==null?`, ${Zs(e)} digits`:"";return`${n}${i}${t?", differs from expected.toml":""}`}var _0=new RegExp(["[\\u0000-\\u001f\\u007f-\\u009f]","[\\u00ad\\u061c\\u180e\\u200b-\\u200f\\u2028-\\u202e\\u2060-\\u2069\\ufeff\\ufff9-\\ufffb]","[\\ud800-\\udbff](?![\\udc00-\\udfff])|(?<![\\ud800-\\udbff])[\\udc00-\\udfff]"].join("|"),"g");function x0(n){return`\\u${n.charCodeAt(0).toString(16).padStart(4,"0")}`}function J(n){return n.replace(_0,x0)}function y0(n){return n.replace(/\r\n/g,`
`).replace(_0,e=>e===`
`||e==="	"?e:x0(e))}var Tf=4096;function b0(n){let[e,t]=et(!1),i=!e&&n.length>Tf;return{shown:i?n.slice(0,Tf):n,rest:i?n.length-Tf:0,open:()=>t(!0)}}function S0({rest:n,open:e}){if(n===0)return null;let t=`${n.toLocaleString("en")} more characters`;return u(Oe,{children:[u("button",{type:"button",class:"more",onClick:e,children:["show ",t]}),u("span",{class:"on-paper",children:["(",t," are not printed)"]})]})}var v0=" (?:[mnp\xB5]?s|m?m|m?rad|kg|[JNW%])(?:[/^][\\w/^]{1,8})?(?![\\w^])",tw="[-+]?\\d{1,20}(?:\\.\\d{1,20})?",nw=new RegExp(`((?<![\\w.])${tw}(?:e[-+]?\\d{1,3}(?:${v0})?|${v0}))`);function qi({text:n}){let e=J(n).split(nw);return u(Oe,{children:e.map((t,i)=>i%2===0?t:u("span",{class:"unbroken",children:t},i))})}function Wn({text:n}){let e=J(n).split(/(?<=[/=_-])/);return u(Oe,{children:e.flatMap((t,i)=>i===0?[t]:[u("wbr",{},i),t])})}function M0(n){return/[.?!]$/.test(n)?n:`${n}.`}function Nt({text:n}){let{shown:e,rest:t,open:i}=b0(n);return u(Oe,{children:[u("bdi",{children:u(qi,{text:e})}),u(S0,{rest:t,open:i})]})}function Oo({text:n,label:e}){let{shown:t,rest:i,open:r}=b0(n);return u(Oe,{children:[u("pre",{class:"output",tabIndex:0,role:"region","aria-label":e,children:y0(t)}),u(S0,{rest:i,open:r})]})}var w0=[[],[9,4],[2,3],[9,3,2,3],[15,4],[5,2]],T0=[[[.9,0],[.78,.45],[.45,.78],[0,.9],[-.45,.78],[-.78,.45],[-.9,0],[-.78,-.45],[-.45,-.78],[0,-.9],[.45,-.78],[.78,-.45]],[[-.8,-.8],[.8,-.8],[.8,.8],[-.8,.8]],[[0,-1.05],[1,.75],[-1,.75]],[[0,-1.15],[1.15,0],[0,1.15],[-1.15,0]],[[0,1.05],[1,-.75],[-1,-.75]],[[-.35,-1],[.35,-1],[.35,-.35],[1,-.35],[1,.35],[.35,.35],[.35,1],[-.35,1],[-.35,.35],[-1,.35],[-1,-.35],[-.35,-.35]],[[0,-1.1],[1.05,-.34],[.65,.9],[-.65,.9],[-1.05,-.34]]];function Ti(n){return{color:`--series-${n%8+1}`,dash:w0[n%w0.length],marker:n%T0.length}}function Bo(n,e,t,i){return`M${T0[n].map(([s,o])=>`${(e+i*s).toFixed(2)},${(t+i*o).toFixed(2)}`).join("L")}Z`}function A0(n,e,t,i,r){let{marker:s,color:o}=Ti(e);n.fillStyle=jn(o),n.fill(new Path2D(Bo(s,t,i,4*r)))}function Rr({style:n,faint:e=!1}){let t=Ti(n),i=`var(${t.color})`;return u("svg",{class:"sample",width:"40",height:"14","aria-hidden":"true",children:[u("line",{x1:"0",x2:"40",y1:"7",y2:"7",stroke:i,"stroke-width":e?1:2,"stroke-dasharray":t.dash.join(" ")}),u("path",{d:Bo(t.marker,20,7,e?3:4.5),fill:e?"var(--ground)":i,stroke:i})]})}function E0(n,e,t){return n.map((i,r)=>({verdict:i,index:r,claim:e?.claims.find(s=>s.label===i.claim)??null,curve:t.find(s=>s.claim===i.claim)??null}))}function C0({until:n}){return n===null?"":`, until ${ge(n)} s`}function iw({claim:n,verdict:e}){return n?.at_least==null?u(Oe,{children:["truth: ",u(rw,{claim:n,verdict:e})]}):u(qi,{text:`must change by at least ${Gn(n.at_least,n.unit)}${C0(n)}`})}function rw({claim:n,verdict:e}){let t=e.truth_error===null?"":`known to ${Gn(e.truth_error,e.unit)}`;if(n===null)return u(qi,{text:t||"not told"});let i=n.follows===""?"its initial value":n.follows,r=n.source?`: ${n.source}`:"",s=C0(n);return u(qi,{text:i+r+(t?` (${t})`:"")+`, ${e.evidence}`+s})}function sw({curve:n,verdict:e}){let t=n?.first_violation;return t?u(Oe,{children:[ge(t.time)," s, step ",t.step,": ",Gn(t.value,n.unit)]}):e.first_bad_step!==null?u(Oe,{children:["not finite from step ",e.first_bad_step]}):n?u(Oe,{children:"none"}):u(Oe,{children:wf(e.status)?"not recorded":""})}function ow({row:{verdict:n,claim:e}}){return u("ul",{class:"notes",children:[n.detail?u("li",{children:u(Nt,{text:n.detail})}):null,n.expected_reason?u("li",{children:["expected.toml: ",u(Nt,{text:n.expected_reason})]}):null,u("li",{children:u(iw,{claim:e,verdict:n})}),u("li",{children:["tolerance: ",u(Nt,{text:n.reason}),n.tolerance_scale===1?"":`; all times ${n.tolerance_scale}`,n.spread===null?null:u(qi,{text:`; runs that start an ulp apart end ${Gn(n.spread,n.unit)} apart`})]})]})}function aw({row:n,shown:e,toggle:t,reasons:i}){let{verdict:r,curve:s,index:o}=n;return u("tbody",{class:lr(r)?"differing":void 0,children:[u("tr",{children:[u("td",{class:"on-screen",children:u("label",{children:[u("input",{type:"checkbox",checked:e,disabled:!s,onChange:()=>t(o)}),u("span",{class:"unseen",children:["show the error curve of ",J(r.claim)]}),s?u(Rr,{style:o}):null]})}),u("td",{children:u(cr,{status:r.status})}),u("th",{scope:"rowgroup",children:J(r.claim)}),u("td",{class:"number",children:xn(r.status)?xc(r):""}),u("td",{class:"number",children:r.allowed===null||!wf(r.status)?"":Gn(r.allowed,r.unit)}),u("td",{class:"number",children:xn(r.status)?ko(ar(r.measured,r.allowed)):""}),u("td",{class:"number",children:u(sw,{curve:s,verdict:r})}),u("td",{class:"expected",children:[r.expected_size===null?r.expected:`${Gn(r.expected_size,r.unit)} within \xD7${r.expected_within}`,lr(r)?u(Yr,{text:"differs"}):null]})]}),i?u("tr",{children:[u("td",{class:"on-screen"}),u("td",{}),u("td",{colSpan:6,children:u(ow,{row:n})})]}):null]})}var lw=["status","claim","measured","allowed","digits","first violation","expected"];function R0({rows:n,shown:e,toggle:t}){let[i,r]=et(!1),[s,o]=et(!0),a=Ue(()=>i?[...n].sort((l,c)=>Za(c.verdict,l.verdict)):n,[n,i]);return u("section",{"aria-labelledby":"claims-heading",children:[u("h3",{id:"claims-heading",children:"Claims"}),u("label",{class:"on-screen",children:[u("input",{type:"checkbox",checked:i,onChange:()=>r(!i)})," worst first"]})," ",u("label",{class:"on-screen",children:[u("input",{type:"checkbox",checked:s,onChange:()=>o(!s)})," truths, bounds and reasons"]}),u("div",{class:"scroll claims",tabIndex:0,role:"region","aria-label":"Claims of this cell",children:u("table",{children:[u("thead",{children:u("tr",{children:[u("th",{scope:"col",class:"on-screen",children:"curve"}),lw.map(l=>u("th",{scope:"col",children:l},l))]})}),a.map(l=>u(aw,{row:l,shown:e.has(l.index),toggle:t,reasons:s},l.index))]})})]})}async function cw(n,e){try{return await navigator.clipboard.writeText(n),!0}catch{return e&&getSelection()?.selectAllChildren(e),!1}}function vc({text:n}){let e=Ht(null),[t,i]=et(""),r=async()=>i(await cw(n,e.current)?"copied":"selected: copy it with the keyboard");return u("p",{class:"command",children:[u("code",{ref:e,children:J(n)})," ",u("button",{type:"button",onClick:r,"aria-label":`Copy the command ${J(n)}`,children:"copy"})," ",u("span",{role:"status",children:t})]})}var Ms=class{constructor(e,t){this.whole=e;this.pinned=this.within(t)}whole;pinned;hovered=null;zoomed=null;running=!1;listeners=new Set;get time(){return this.hovered??this.pinned}get pin(){return this.pinned}set pin(e){this.pinned=this.within(e),this.announce()}hover(e){let t=e===null||this.running?null:this.within(e);t!==this.hovered&&(this.hovered=t,this.announce())}get window(){return this.zoomed}set window(e){let i=e!==null&&e[0]<=this.whole[0]&&e[1]>=this.whole[1]?null:e;i?.[0]===this.zoomed?.[0]&&i?.[1]===this.zoomed?.[1]||(this.zoomed=i,this.announce())}lookCloser(){let[e,t]=this.zoomed??this.whole,i=(t-e)/4,r=Math.min(t-i,Math.max(e+i,this.time));this.window=[r-i,r+i]}listen(e){return this.listeners.add(e),()=>{this.listeners.delete(e)}}within(e){return Math.min(this.whole[1],Math.max(this.whole[0],e))}announce(){for(let e of this.listeners)e()}};function bc(n){let[,e]=et(0);return Rt(()=>{let t=0,i=n.listen(()=>{t||=requestAnimationFrame(()=>{t=0,e(r=>r+1)})});return()=>{i(),cancelAnimationFrame(t)}},[n]),n.time}function Sc(n){let e={least:1/0,leastAt:0,greatest:-1/0,greatestAt:0,zeros:0,lost:0,lostAt:null};for(let t=0;t<n.value.length;++t){let i=n.value[t],r=n.time[t];if(!Number.isFinite(i)){++e.lost,e.lostAt??=r;continue}i===0&&++e.zeros,i<e.least&&([e.least,e.leastAt]=[i,r]),i>e.greatest&&([e.greatest,e.greatestAt]=[i,r])}return Number.isFinite(e.greatest)?e:null}function Pr(n,e){if(n.length===0)return-1;let t=0,i=n.length-1;for(;t<i;){let r=t+i>>1;n[r]<e?t=r+1:i=r}return t>0&&e-n[t-1]<=n[t]-e?t-1:t}function P0(n){let e=1/0;for(let t of n){for(let i=0;i<t.value.length;++i){let r=t.value[i];r>0&&r<e&&(e=r)}t.allowed!=null&&t.allowed>0&&(e=Math.min(e,t.allowed))}return Number.isFinite(e)?10**(Math.floor(Math.log10(e))-1):1e-16}function I0(n,e){let t=new Set;for(let o of n)for(let a=0;a<o.time.length;++a)t.add(o.time[a]);let i=[...t].sort((o,a)=>o-a),r=new Map(i.map((o,a)=>[o,a])),s=n.map(o=>{let a=new Array(i.length).fill(void 0);for(let l=0;l<o.time.length;++l){let c=r.get(o.time[l]),h=o.value[l],f=Number.isFinite(h)?e===null?h:Math.max(h,e):null,d=a[c];(d===void 0||f!==null&&(d===null||Math.abs(f)>Math.abs(d)))&&(a[c]=f)}return a});return[i,...s]}function L0(n){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let i=0;i<n.length;++i){let r=n[i];Number.isFinite(r)&&(r<e[i%3]&&(e[i%3]=r),r>t[i%3]&&(t[i%3]=r))}return e.every(Number.isFinite)?{min:[e[0],e[1],e[2]],max:[t[0],t[1],t[2]]}:null}function Mc({min:n,max:e}){return Math.hypot(e[0]-n[0],e[1]-n[1],e[2]-n[2])}function uw(n,e){let[t,i]=[n.min.map((r,s)=>Math.min(r,e.min[s])),n.max.map((r,s)=>Math.max(r,e.max[s]))];return{min:[t[0],t[1],t[2]],max:[i[0],i[1],i[2]]}}function wc(n,e){let t=n?L0(n.position):null;if(t&&n.time.length>1)return t;let r=e.flatMap(s=>s?[L0(s.position)]:[]).filter(s=>s!==null).sort((s,o)=>Mc(s)-Mc(o))[0]??null;return r&&t?uw(r,t):r??t}function hw(n,e,t,i){let r=Pr(n.time,i),s=n.time[r]>i?Math.max(0,r-1):r,o=Math.min(n.time.length-1,s+1),a=n.time[o]-n.time[s],l=a>0?Math.min(1,Math.max(0,(i-n.time[s])/a)):0,[c,h]=[n.position[s*e+t],n.position[o*e+t]];return c+l*(h-c)}function D0(n,e,t){if(n.time.length===0||e.time.length===0)return null;let i=n.position.length/n.time.length;if(e.position.length/e.time.length!==i)return null;for(let r=0;r<n.time.length;++r){let s=n.time[r];for(let o=0;o<i/3;++o){let a=[0,1,2].map(c=>n.position[r*i+3*o+c]-hw(e,i,3*o+c,s)),l=Math.hypot(...a);if(!Number.isFinite(l)||l>t)return{time:s,body:o,distance:Number.isFinite(l)?l:1/0}}}return null}var dw="uplot",fw="u-hz",pw="u-vt",mw="u-title",gw="u-wrap",_w="u-under",xw="u-over",yw="u-axis",Qs="u-off",vw="u-select",bw="u-cursor-x",Sw="u-cursor-y",Mw="u-cursor-pt",ww="u-legend",Tw="u-live",Aw="u-inline",Ew="u-series",Cw="u-marker",N0="u-label",Rw="u-value",ja="width",Qa="height";var F0="bottom",Vo="left",Af="right",Gf="#000",U0=Gf+"0",Ef="mousemove",k0="mousedown",Cf="mouseup",O0="mouseenter",B0="mouseleave",V0="dblclick",Pw="resize",Iw="scroll",z0="change",Rc="dppxchange",Wf="--",qo=typeof window<"u",Df=qo?document:null,Ho=qo?window:null,Lw=qo?navigator:null,Ft,Tc;function Nf(){let n=devicePixelRatio;Ft!=n&&(Ft=n,Tc&&Uf(z0,Tc,Nf),Tc=matchMedia(`(min-resolution: ${Ft-.001}dppx) and (max-resolution: ${Ft+.001}dppx)`),eo(z0,Tc,Nf),Ho.dispatchEvent(new CustomEvent(Rc)))}function Ai(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Ff(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function tn(n,e,t){n.style[e]=t+"px"}function ur(n,e,t,i){let r=Df.createElement(n);return e!=null&&Ai(r,e),t?.insertBefore(r,i),r}function Yi(n,e){return ur("div",n,e)}var H0=new WeakMap;function Ir(n,e,t,i,r){let s="translate("+e+"px,"+t+"px)",o=H0.get(n);s!=o&&(n.style.transform=s,H0.set(n,s),e<0||t<0||e>i||t>r?Ai(n,Qs):Ff(n,Qs))}var G0=new WeakMap;function W0(n,e,t){let i=e+t,r=G0.get(n);i!=r&&(G0.set(n,i),n.style.background=e,n.style.borderColor=t)}var $0=new WeakMap;function X0(n,e,t,i){let r=e+""+t,s=$0.get(n);r!=s&&($0.set(n,r),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var $f={passive:!0},Dw={...$f,capture:!0};function eo(n,e,t,i){e.addEventListener(n,t,i?Dw:$f)}function Uf(n,e,t,i){e.removeEventListener(n,t,$f)}qo&&Nf();function hr(n,e,t,i){let r;t=t||0,i=i||e.length-1;let s=i<=2147483647;for(;i-t>1;)r=s?t+i>>1:Ei((t+i)/2),e[r]<n?t=r:i=r;return n-e[t]<=e[i]-n?t:i}function v_(n){return(t,i,r)=>{let s=-1,o=-1;for(let a=i;a<=r;a++)if(n(t[a])){s=a;break}for(let a=r;a>=i;a--)if(n(t[a])){o=a;break}return[s,o]}}var b_=n=>n!=null,S_=n=>n!=null&&n>0,Lc=v_(b_),Nw=v_(S_);function Fw(n,e,t,i=0,r=!1){let s=r?Nw:Lc,o=r?S_:b_;[e,t]=s(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Xt,l??-Xt]}function Dc(n,e,t,i){let r=J0(n),s=J0(e);n==e&&(r==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Jr:M_,a=r==1?Ei:Ji,l=s==1?Ji:Ei,c=a(o(Nn(n))),h=l(o(Nn(e))),f=Go(t,c),d=Go(t,h);return t==10&&(c<0&&(f=qt(f,-c)),h<0&&(d=qt(d,-h))),i||t==2?(n=f*r,e=d*s):(n=E_(n,f),e=Nc(e,d)),[n,e]}function Xf(n,e,t,i){let r=Dc(n,e,t,i);return n==0&&(r[0]=0),e==0&&(r[1]=0),r}var qf=.1,q0={mode:3,pad:qf},tl={pad:0,soft:null,mode:0},Uw={min:tl,max:tl};function Pc(n,e,t,i){return Fc(t)?Y0(n,e,t):(tl.pad=t,tl.soft=i?0:null,tl.mode=i?3:0,Y0(n,e,Uw))}function Lt(n,e){return n??e}function kw(n,e,t){for(e=Lt(e,0),t=Lt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Y0(n,e,t){let i=t.min,r=t.max,s=Lt(i.pad,0),o=Lt(r.pad,0),a=Lt(i.hard,-Xt),l=Lt(r.hard,Xt),c=Lt(i.soft,Xt),h=Lt(r.soft,-Xt),f=Lt(i.mode,0),d=Lt(r.mode,0),p=e-n,m=Jr(p),x=ci(Nn(n),Nn(e)),_=Jr(x),g=Nn(_-m);(p<1e-24||g>10)&&(p=0,(n==0||e==0)&&(p=1e-24,f==2&&c!=Xt&&(s=0),d==2&&h!=-Xt&&(o=0)));let v=p||x||1e3,E=Jr(v),M=Go(10,Ei(E)),I=v*(p==0?n==0?.1:1:s),C=qt(E_(n-I,M/10),24),b=n>=c&&(f==1||f==3&&C<=c||f==2&&C>=c)?c:Xt,A=ci(a,C<b&&n>=b?b:dr(b,C)),G=v*(p==0?e==0?.1:1:o),F=qt(Nc(e+G,M/10),24),D=e<=h&&(d==1||d==3&&F>=h||d==2&&F<=h)?h:-Xt,H=dr(l,F>D&&e<=D?D:ci(D,F));return A==H&&A==0&&(H=100),[A,H]}var Ow=new Intl.NumberFormat(qo?Lw.language:"en-US"),Yf=n=>Ow.format(n),Ci=Math,Cc=Ci.PI,Nn=Ci.abs,Ei=Ci.floor,Dn=Ci.round,Ji=Ci.ceil,dr=Ci.min,ci=Ci.max,Go=Ci.pow,J0=Ci.sign,Jr=Ci.log10,M_=Ci.log2,Bw=(n,e=1)=>Ci.sinh(n)*e,Rf=(n,e=1)=>Ci.asinh(n/e),Xt=1/0;function Z0(n){return(Jr((n^n>>31)-(n>>31))|0)+1}function kf(n,e,t){return dr(ci(n,e),t)}function w_(n){return typeof n=="function"}function wt(n){return w_(n)?n:()=>n}var Vw=()=>{},T_=n=>n,A_=(n,e)=>e,zw=n=>null,K0=n=>!0,j0=(n,e)=>n==e,Hw=/\.\d*?(?=9{6,}|0{6,})/gm,to=n=>{if(R_(n)||Ts.has(n))return n;let e=`${n}`,t=e.match(Hw);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[r,s]=e.split("e");return+`${to(r)}e${s}`}return qt(n,i)};function Ks(n,e){return to(qt(to(n/e))*e)}function Nc(n,e){return to(Ji(to(n/e))*e)}function E_(n,e){return to(Ei(to(n/e))*e)}function qt(n,e=0){if(R_(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Dn(i)/t}var Ts=new Map;function C_(n){return((""+n).split(".")[1]||"").length}function il(n,e,t,i){let r=[],s=i.map(C_);for(let o=e;o<t;o++){let a=Nn(o),l=qt(Go(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=s[c]?0:s[c]),d=n==10?h:qt(h,f);r.push(d),Ts.set(d,f)}}return r}var nl={},Jf=[],Wo=[null,null],ws=Array.isArray,R_=Number.isInteger,Gw=n=>n===void 0;function Q0(n){return typeof n=="string"}function Fc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Ww(n){return n!=null&&typeof n=="object"}var $w=Object.getPrototypeOf(Uint8Array),P_="__proto__";function $o(n,e=Fc){let t;if(ws(n)){let i=n.find(r=>r!=null);if(ws(i)||e(i)){t=Array(n.length);for(let r=0;r<n.length;r++)t[r]=$o(n[r],e)}else t=n.slice()}else if(n instanceof $w)t=n.slice();else if(e(n)){t={};for(let i in n)i!=P_&&(t[i]=$o(n[i],e))}else t=n;return t}function En(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let r in i)r!=P_&&(Fc(n[r])?En(n[r],$o(i[r])):n[r]=$o(i[r]))}return n}var Xw=0,qw=1,Yw=2;function Jw(n,e,t){for(let i=0,r,s=-1;i<e.length;i++){let o=e[i];if(o>s){for(r=o-1;r>=0&&n[r]==null;)n[r--]=null;for(r=o+1;r<t&&n[r]==null;)n[s=r++]=null}}}function Zw(n,e){if(Qw(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return e1(o[0])||(o=jw(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let i=[Array.from(t).sort((o,a)=>o-a)],r=i[0].length,s=new Map;for(let o=0;o<r;o++)s.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],f=Array(r).fill(void 0),d=e?e[o][c]:qw,p=[];for(let m=0;m<h.length;m++){let x=h[m],_=s.get(l[m]);x===null?d!=Xw&&(f[_]=x,d==Yw&&p.push(_)):f[_]=x}Jw(f,p,r),i.push(f)}}return i}var Kw=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function jw(n){let e=n[0],t=e.length,i=Array(t);for(let s=0;s<i.length;s++)i[s]=s;i.sort((s,o)=>e[s]-e[o]);let r=[];for(let s=0;s<n.length;s++){let o=n[s],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];r.push(a)}return r}function Qw(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let r=n[i][0];if(r.length!=t)return!1;if(r!=e){for(let s=0;s<t;s++)if(r[s]!=e[s])return!1}}return!0}function e1(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,r=t-1;for(;i<=r&&n[i]==null;)i++;for(;r>=i&&n[r]==null;)r--;if(r<=i)return!0;let s=ci(1,Ei((r-i+1)/e));for(let o=n[i],a=i+s;a<=r;a+=s){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var I_=["January","February","March","April","May","June","July","August","September","October","November","December"],L_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function D_(n){return n.slice(0,3)}var t1=L_.map(D_),n1=I_.map(D_),i1={MMMM:I_,MMM:n1,WWWW:L_,WWW:t1};function Ka(n){return(n<10?"0":"")+n}function r1(n){return(n<10?"00":n<100?"0":"")+n}var s1={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Ka(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ka(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Ka(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ka(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ka(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>r1(n.getMilliseconds())};function Zf(n,e){e=e||i1;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=i.exec(n);)t.push(r[0][0]=="{"?s1[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](s,e);return o}}var o1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function a1(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==o1?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var N_=n=>n%1==0,Ic=[1,2,2.5,5],l1=il(10,-32,0,Ic),F_=il(10,0,32,Ic),c1=F_.filter(N_),js=l1.concat(F_),Kf=`
`,U_="{YYYY}",e_=Kf+U_,k_="{M}/{D}",el=Kf+k_,Ac=el+"/{YY}",O_="{aa}",u1="{h}:{mm}",zo=u1+O_,t_=Kf+zo,n_=":{ss}",Ut=null;function B_(n){let e=n*1e3,t=e*60,i=t*60,r=i*24,s=r*30,o=r*365,l=(n==1?il(10,0,3,Ic).filter(N_):il(10,-3,0,Ic)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,U_,Ut,Ut,Ut,Ut,Ut,Ut,1],[r*28,"{MMM}",e_,Ut,Ut,Ut,Ut,Ut,1],[r,k_,e_,Ut,Ut,Ut,Ut,Ut,1],[i,"{h}"+O_,Ac,Ut,el,Ut,Ut,Ut,1],[t,zo,Ac,Ut,el,Ut,Ut,Ut,1],[e,n_,Ac+" "+zo,Ut,el+" "+zo,Ut,t_,Ut,1],[n,n_+".{fff}",Ac+" "+zo,Ut,el+" "+zo,Ut,t_,Ut,1]];function h(f){return(d,p,m,x,_,g)=>{let v=[],E=_>=o,M=_>=s&&_<o,I=f(m),C=qt(I*n,3),b=Pf(I.getFullYear(),E?0:I.getMonth(),M||E?1:I.getDate()),A=qt(b*n,3);if(M||E){let G=M?_/s:0,F=E?_/o:0,D=C==A?C:qt(Pf(b.getFullYear()+F,b.getMonth()+G,1)*n,3),H=new Date(Dn(D/n)),V=H.getFullYear(),N=H.getMonth();for(let W=0;D<=x;W++){let K=Pf(V+F*W,N+G*W,1),z=K-f(qt(K*n,3));D=qt((+K+z)*n,3),D<=x&&v.push(D)}}else{let G=_>=r?r:_,F=Ei(m)-Ei(C),D=A+F+Nc(C-A,G);v.push(D);let H=f(D),V=H.getHours()+H.getMinutes()/t+H.getSeconds()/i,N=_/i,W=d.axes[p]._space,K=g/W;for(;D=qt(D+_,n==1?0:3),!(D>x);)if(N>1){let z=Ei(qt(V+N,6))%24,ee=f(D).getHours()-z;ee>1&&(ee=-1),D-=ee*i,V=(V+N)%24;let se=v[v.length-1];qt((D-se)/_,3)*K>=.7&&v.push(D)}else v.push(D)}return v}}return[l,c,h]}var[h1,d1,f1]=B_(1),[p1,m1,g1]=B_(.001);il(2,-53,53,[1]);function i_(n,e){return n.map(t=>t.map((i,r)=>r==0||r==8||i==null?i:e(r==1||t[8]==0?i:t[1]+i)))}function r_(n,e){return(t,i,r,s,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,h,f,d,p;return i.map(m=>{let x=n(m),_=x.getFullYear(),g=x.getMonth(),v=x.getDate(),E=x.getHours(),M=x.getMinutes(),I=x.getSeconds(),C=_!=l&&a[2]||g!=c&&a[3]||v!=h&&a[4]||E!=f&&a[5]||M!=d&&a[6]||I!=p&&a[7]||a[1];return l=_,c=g,h=v,f=E,d=M,p=I,C(x)})}}function _1(n,e){let t=Zf(e);return(i,r,s,o,a)=>r.map(l=>t(n(l)))}function Pf(n,e,t){return new Date(n,e,t)}function s_(n,e){return e(n)}var x1="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function o_(n,e){return(t,i,r,s)=>s==null?Wf:e(n(i))}function y1(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function v1(n,e){return n.series[e].fill(n,e)}var b1={show:!0,live:!0,isolate:!1,mount:Vw,markers:{show:!0,width:2,stroke:y1,fill:v1,dash:"solid"},idx:null,idxs:null,values:[]};function S1(n,e){let t=n.cursor.points,i=Yi(),r=t.size(n,e);tn(i,ja,r),tn(i,Qa,r);let s=r/-2;tn(i,"marginLeft",s),tn(i,"marginTop",s);let o=t.width(n,e,r);return o&&tn(i,"borderWidth",o),i}function M1(n,e){let t=n.series[e].points;return t._fill||t._stroke}function w1(n,e){let t=n.series[e].points;return t._stroke||t._fill}function T1(n,e){return n.series[e].points.size}var If=[0,0];function A1(n,e,t){return If[0]=e,If[1]=t,If}function Ec(n,e,t,i=!0){return r=>{r.button==0&&(!i||r.target==e)&&t(r)}}function Lf(n,e,t,i=!0){return r=>{(!i||r.target==e)&&t(r)}}var E1={show:!0,x:!0,y:!0,lock:!1,move:A1,points:{one:!1,show:S1,size:T1,width:0,stroke:w1,fill:M1},bind:{mousedown:Ec,mouseup:Ec,click:Ec,dblclick:Ec,mousemove:Lf,mouseleave:Lf,mouseenter:Lf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,r)=>i-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},V_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},jf=En({},V_,{filter:A_}),z_=En({},jf,{size:10}),H_=En({},V_,{show:!1}),Qf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',G_="bold "+Qf,W_=1.5,a_={show:!0,scale:"x",stroke:Gf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:G_,side:2,grid:jf,ticks:z_,border:H_,font:Qf,lineGap:W_,rotate:0},C1="Value",R1="Time",l_={show:!0,scale:"x",auto:!1,sorted:1,min:Xt,max:-Xt,idxs:[]};function P1(n,e,t,i,r){return e.map(s=>s==null?"":Yf(s))}function I1(n,e,t,i,r,s,o){let a=[],l=Ts.get(r)||0;t=o?t:qt(Nc(t,r),l);for(let c=t;c<=i;c=qt(c+r,l))a.push(Object.is(c,-0)?0:c);return a}function Of(n,e,t,i,r,s,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Jr:M_,h=Ei(c(t));r=Go(l,h),l==10&&(r=js[hr(r,js)]);let f=t,d=r*l;l==10&&(d=js[hr(d,js)]);do a.push(f),f=f+r,l==10&&!Ts.has(f)&&(f=qt(f,Ts.get(r))),f>=d&&(r=f,d=r*l,l==10&&(d=js[hr(d,js)]));while(f<=i);return a}function L1(n,e,t,i,r,s,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Of(n,e,ci(l,t),i,r):[l],h=i>=0&&t<=0?[0]:[];return(t<-l?Of(n,e,ci(l,-i),-t,r):[l]).reverse().map(d=>-d).concat(h,c)}var $_=/./,D1=/[12357]/,N1=/[125]/,c_=/1/,Bf=(n,e,t,i)=>n.map((r,s)=>e==4&&r==0||s%i==0&&t.test(r.toExponential()[r<0?1:0])?r:null);function F1(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=n.scales[o],l=n.valToPos,c=s._space,h=l(10,o),f=l(9,o)-h>=c?$_:l(7,o)-h>=c?D1:l(5,o)-h>=c?N1:c_;if(f==c_){let d=Nn(l(1,o)-h);if(d<c)return Bf(e.slice().reverse(),a.distr,f,Ji(c/d)).reverse()}return Bf(e,a.distr,f,1)}function U1(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=s._space,l=n.valToPos,c=Nn(l(1,o)-l(2,o));return c<a?Bf(e.slice().reverse(),3,$_,Ji(a/c)).reverse():e}function k1(n,e,t,i){return i==null?Wf:e==null?"":Yf(e)}var u_={show:!0,scale:"y",stroke:Gf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:G_,side:3,grid:jf,ticks:z_,border:H_,font:Qf,lineGap:W_,rotate:0};function O1(n,e){let t=3+(n||1)*2;return qt(t*e,3)}function B1(n,e){let{scale:t,idxs:i}=n.series[0],r=n._data[0],s=n.valToPos(r[i[0]],t,!0),o=n.valToPos(r[i[1]],t,!0),a=Nn(o-s),l=n.series[e],c=a/(l.points.space*Ft);return i[1]-i[0]<=c}var h_={scale:null,auto:!0,sorted:0,min:Xt,max:-Xt},X_=(n,e,t,i,r)=>r,d_={show:!0,auto:!0,sorted:0,gaps:X_,alpha:1,facets:[En({},h_,{scale:"x"}),En({},h_,{scale:"y"})]},f_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:X_,alpha:1,points:{show:B1,filter:null},values:null,min:Xt,max:-Xt,idxs:[],path:null,clip:null};function V1(n,e,t,i,r){return t/10}var q_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},z1=En({},q_,{time:!1,ori:1}),p_={};function Y_(n,e){let t=p_[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(r=>r!=i)},pub(i,r,s,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=r&&t.plots[h].pub(i,r,s,o,a,l,c)}},n!=null&&(p_[n]=t)),t}var Xo=1,Vf=2;function no(n,e,t){let i=n.mode,r=n.series[e],s=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=s[0],c=i==2?s[1]:s[e],h=i==2?o[r.facets[0].scale]:o[n.series[0].scale],f=i==2?o[r.facets[1].scale]:o[r.scale],d=a.left,p=a.top,m=a.width,x=a.height,_=n.valToPosH,g=n.valToPosV;return h.ori==0?t(r,l,c,h,f,_,g,d,p,m,x,kc,Yo,Bc,Z_,j_):t(r,l,c,h,f,g,_,p,d,x,m,Oc,Jo,np,K_,Q_)}function ep(n,e){let t=0,i=0,r=Lt(n.bands,Jf);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function H1(n,e,t,i,r){let s=n.mode,o=n.series[e],a=s==2?o.facets[1].scale:o.scale,l=n.scales[a];return r==-1?l.min:r==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Zr(n,e,t,i,r,s){return no(n,e,(o,a,l,c,h,f,d,p,m,x,_)=>{let g=o.pxRound,v=c.dir*(c.ori==0?1:-1),E=c.ori==0?Yo:Jo,M,I;v==1?(M=t,I=i):(M=i,I=t);let C=g(f(a[M],c,x,p)),b=g(d(l[M],h,_,m)),A=g(f(a[I],c,x,p)),G=g(d(s==1?h.max:h.min,h,_,m)),F=new Path2D(r);return E(F,A,G),E(F,C,G),E(F,C,b),F})}function Uc(n,e,t,i,r,s){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Bc:np,l=t;for(let f=0;f<n.length;f++){let d=n[f];if(d[1]>d[0]){let p=d[0]-l;p>0&&a(o,l,i,p,i+s),l=d[1]}}let c=t+r-l,h=10;c>0&&a(o,l,i-h/2,c,i+s+h)}return o}function G1(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function tp(n,e,t,i,r,s,o){let a=[],l=n.length;for(let c=r==1?t:i;c>=t&&c<=i;c+=r)if(e[c]===null){let f=c,d=c;if(r==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let p=s(n[f]),m=d==f?p:s(n[d]),x=f-r;p=o<=0&&x>=0&&x<l?s(n[x]):p;let g=d+r;m=o>=0&&g>=0&&g<l?s(n[g]):m,m>=p&&a.push([p,m])}return a}function m_(n){return n==0?T_:n==1?Dn:e=>Ks(e,n)}function J_(n){let e=n==0?kc:Oc,t=n==0?(r,s,o,a,l,c)=>{r.arcTo(s,o,a,l,c)}:(r,s,o,a,l,c)=>{r.arcTo(o,s,l,a,c)},i=n==0?(r,s,o,a,l)=>{r.rect(s,o,a,l)}:(r,s,o,a,l)=>{r.rect(o,s,l,a)};return(r,s,o,a,l,c=0,h=0)=>{c==0&&h==0?i(r,s,o,a,l):(c=dr(c,a/2,l/2),h=dr(h,a/2,l/2),e(r,s+c,o),t(r,s+a,o,s+a,o+l,c),t(r,s+a,o+l,s,o+l,h),t(r,s,o+l,s,o,h),t(r,s,o,s+a,o,c),r.closePath())}}var kc=(n,e,t)=>{n.moveTo(e,t)},Oc=(n,e,t)=>{n.moveTo(t,e)},Yo=(n,e,t)=>{n.lineTo(e,t)},Jo=(n,e,t)=>{n.lineTo(t,e)},Bc=J_(0),np=J_(1),Z_=(n,e,t,i,r,s)=>{n.arc(e,t,i,r,s)},K_=(n,e,t,i,r,s)=>{n.arc(t,e,i,r,s)},j_=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(e,t,i,r,s,o)},Q_=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(t,e,r,i,o,s)};function ex(n){return(e,t,i,r,s)=>no(e,t,(o,a,l,c,h,f,d,p,m,x,_)=>{let{pxRound:g,points:v}=o,E,M;c.ori==0?(E=kc,M=Z_):(E=Oc,M=K_);let I=qt(v.width*Ft,3),C=(v.size-v.width)/2*Ft,b=qt(C*2,3),A=new Path2D,G=new Path2D,{left:F,top:D,width:H,height:V}=e.bbox;Bc(G,F-b,D-b,H+b*2,V+b*2);let N=W=>{if(l[W]!=null){let K=g(f(a[W],c,x,p)),z=g(d(l[W],h,_,m));E(A,K+C,z),M(A,K,z,C,0,Cc*2)}};if(s)s.forEach(N);else for(let W=i;W<=r;W++)N(W);return{stroke:I>0?A:null,fill:A,clip:G,flags:Xo|Vf}})}function tx(n){return(e,t,i,r,s,o)=>{i!=r&&(s!=i&&o!=i&&n(e,t,i),s!=r&&o!=r&&n(e,t,r),n(e,t,o))}}var W1=tx(Yo),$1=tx(Jo);function nx(n){let e=Lt(n?.alignGaps,0);return(t,i,r,s)=>no(t,i,(o,a,l,c,h,f,d,p,m,x,_)=>{[r,s]=Lc(l,r,s);let g=o.pxRound,v=V=>g(f(V,c,x,p)),E=V=>g(d(V,h,_,m)),M,I;c.ori==0?(M=Yo,I=W1):(M=Jo,I=$1);let C=c.dir*(c.ori==0?1:-1),b={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Xo},A=b.stroke,G=!1;if(s-r>=x*4){let V=de=>t.posToVal(de,c.key,!0),N=null,W=null,K,z,ue,j=v(a[C==1?r:s]),ee=v(a[r]),se=v(a[s]),fe=V(C==1?ee+1:se-1);for(let de=C==1?r:s;de>=r&&de<=s;de+=C){let te=a[de],ve=(C==1?te<fe:te>fe)?j:v(te),Re=l[de];ve==j?Re!=null?(z=Re,N==null?(M(A,ve,E(z)),K=N=W=z):z<N?N=z:z>W&&(W=z)):Re===null&&(G=!0):(N!=null&&I(A,j,E(N),E(W),E(K),E(z)),Re!=null?(z=Re,M(A,ve,E(z)),N=W=K=z):(N=W=null,Re===null&&(G=!0)),j=ve,fe=V(j+C))}N!=null&&N!=W&&ue!=j&&I(A,j,E(N),E(W),E(K),E(z))}else for(let V=C==1?r:s;V>=r&&V<=s;V+=C){let N=l[V];N===null?G=!0:N!=null&&M(A,v(a[V]),E(N))}let[D,H]=ep(t,i);if(o.fill!=null||D!=0){let V=b.fill=new Path2D(A),N=o.fillTo(t,i,o.min,o.max,D),W=E(N),K=v(a[r]),z=v(a[s]);C==-1&&([z,K]=[K,z]),M(V,z,W),M(V,K,W)}if(!o.spanGaps){let V=[];G&&V.push(...tp(a,l,r,s,C,v,e)),b.gaps=V=o.gaps(t,i,r,s,V),b.clip=Uc(V,c.ori,p,m,x,_)}return H!=0&&(b.band=H==2?[Zr(t,i,r,s,A,-1),Zr(t,i,r,s,A,1)]:Zr(t,i,r,s,A,H)),b})}function X1(n){let e=Lt(n.align,1),t=Lt(n.ascDesc,!1),i=Lt(n.alignGaps,0),r=Lt(n.extend,!1);return(s,o,a,l)=>no(s,o,(c,h,f,d,p,m,x,_,g,v,E)=>{[a,l]=Lc(f,a,l);let M=c.pxRound,{left:I,width:C}=s.bbox,b=ee=>M(m(ee,d,v,_)),A=ee=>M(x(ee,p,E,g)),G=d.ori==0?Yo:Jo,F={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Xo},D=F.stroke,H=d.dir*(d.ori==0?1:-1),V=A(f[H==1?a:l]),N=b(h[H==1?a:l]),W=N,K=N;r&&e==-1&&(K=I,G(D,K,V)),G(D,N,V);for(let ee=H==1?a:l;ee>=a&&ee<=l;ee+=H){let se=f[ee];if(se==null)continue;let fe=b(h[ee]),de=A(se);e==1?G(D,fe,V):G(D,W,de),G(D,fe,de),V=de,W=fe}let z=W;r&&e==1&&(z=I+C,G(D,z,V));let[ue,j]=ep(s,o);if(c.fill!=null||ue!=0){let ee=F.fill=new Path2D(D),se=c.fillTo(s,o,c.min,c.max,ue),fe=A(se);G(ee,z,fe),G(ee,K,fe)}if(!c.spanGaps){let ee=[];ee.push(...tp(h,f,a,l,H,b,i));let se=c.width*Ft/2,fe=t||e==1?se:-se,de=t||e==-1?-se:se;ee.forEach(te=>{te[0]+=fe,te[1]+=de}),F.gaps=ee=c.gaps(s,o,a,l,ee),F.clip=Uc(ee,d.ori,_,g,v,E)}return j!=0&&(F.band=j==2?[Zr(s,o,a,l,D,-1),Zr(s,o,a,l,D,1)]:Zr(s,o,a,l,D,j)),F})}function g_(n,e,t,i,r,s,o=Xt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let h=Nn(n[l]-n[a]);h<c&&(c=h,o=Nn(t(n[l],i,r,s)-t(n[a],i,r,s)))}a=l}}return o}function q1(n){n=n||nl;let e=Lt(n.size,[.6,Xt,1]),t=n.align||0,i=n.gap||0,r=n.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=wt(r),o=1-e[0],a=Lt(e[1],Xt),l=Lt(e[2],1),c=Lt(n.disp,nl),h=Lt(n.each,p=>{}),{fill:f,stroke:d}=c;return(p,m,x,_)=>no(p,m,(g,v,E,M,I,C,b,A,G,F,D)=>{let H=g.pxRound,V=t,N=i*Ft,W=a*Ft,K=l*Ft,z,ue;M.ori==0?[z,ue]=s(p,m):[ue,z]=s(p,m);let j=M.dir*(M.ori==0?1:-1),ee=M.ori==0?Bc:np,se=M.ori==0?h:(Ie,Ze,ut,Te,$t,We,Je)=>{h(Ie,Ze,ut,$t,Te,Je,We)},fe=Lt(p.bands,Jf).find(Ie=>Ie.series[0]==m),de=fe!=null?fe.dir:0,te=g.fillTo(p,m,g.min,g.max,de),_e=H(b(te,I,D,G)),ve,Re,we,qe=F,ct=H(g.width*Ft),$e=!1,_t=null,ft=null,at=null,rn=null;f!=null&&(ct==0||d!=null)&&($e=!0,_t=f.values(p,m,x,_),ft=new Map,new Set(_t).forEach(Ie=>{Ie!=null&&ft.set(Ie,new Path2D)}),ct>0&&(at=d.values(p,m,x,_),rn=new Map,new Set(at).forEach(Ie=>{Ie!=null&&rn.set(Ie,new Path2D)})));let{x0:Yt,size:yn}=c;if(Yt!=null&&yn!=null){V=1,v=Yt.values(p,m,x,_),Yt.unit==2&&(v=v.map(ut=>p.posToVal(A+ut*F,M.key,!0)));let Ie=yn.values(p,m,x,_);yn.unit==2?Re=Ie[0]*F:Re=C(Ie[0],M,F,A)-C(0,M,F,A),qe=g_(v,E,C,M,F,A,qe),we=qe-Re+N}else qe=g_(v,E,C,M,F,A,qe),we=qe*o+N,Re=qe-we;we<1&&(we=0),ct>=Re/2&&(ct=0),we<5&&(H=T_);let Gt=we>0,On=qe-we-(Gt?ct:0);Re=H(kf(On,K,W)),ve=(V==0?Re/2:V==j?0:Re)-V*j*((V==0?N/2:0)+(Gt?ct/2:0));let At={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Pn=$e?null:new Path2D,cn=null;if(fe!=null)cn=p.data[fe.series[1]];else{let{y0:Ie,y1:Ze}=c;Ie!=null&&Ze!=null&&(E=Ze.values(p,m,x,_),cn=Ie.values(p,m,x,_))}let vn=z*Re,k=ue*Re;for(let Ie=j==1?x:_;Ie>=x&&Ie<=_;Ie+=j){let Ze=E[Ie];if(Ze==null)continue;if(cn!=null){let $=cn[Ie]??0;if(Ze-$==0)continue;_e=b($,I,D,G)}let ut=M.distr!=2||c!=null?v[Ie]:Ie,Te=C(ut,M,F,A),$t=b(Lt(Ze,te),I,D,G),We=H(Te-ve),Je=H(ci($t,_e)),R=H(dr($t,_e)),S=Je-R;if(Ze!=null){let $=Ze<0?k:vn,he=Ze<0?vn:k;$e?(ct>0&&at[Ie]!=null&&ee(rn.get(at[Ie]),We,R+Ei(ct/2),Re,ci(0,S-ct),$,he),_t[Ie]!=null&&ee(ft.get(_t[Ie]),We,R+Ei(ct/2),Re,ci(0,S-ct),$,he)):ee(Pn,We,R+Ei(ct/2),Re,ci(0,S-ct),$,he),se(p,m,Ie,We-ct/2,R,Re+ct,S)}}return ct>0?At.stroke=$e?rn:Pn:$e||(At._fill=g.width==0?g._fill:g._stroke??g._fill,At.width=0),At.fill=$e?ft:Pn,At})}function Y1(n,e){let t=Lt(e?.alignGaps,0);return(i,r,s,o)=>no(i,r,(a,l,c,h,f,d,p,m,x,_,g)=>{[s,o]=Lc(c,s,o);let v=a.pxRound,E=z=>v(d(z,h,_,m)),M=z=>v(p(z,f,g,x)),I,C,b;h.ori==0?(I=kc,b=Yo,C=j_):(I=Oc,b=Jo,C=Q_);let A=h.dir*(h.ori==0?1:-1),G=E(l[A==1?s:o]),F=G,D=[],H=[];for(let z=A==1?s:o;z>=s&&z<=o;z+=A)if(c[z]!=null){let j=l[z],ee=E(j);D.push(F=ee),H.push(M(c[z]))}let V={stroke:n(D,H,I,b,C,v),fill:null,clip:null,band:null,gaps:null,flags:Xo},N=V.stroke,[W,K]=ep(i,r);if(a.fill!=null||W!=0){let z=V.fill=new Path2D(N),ue=a.fillTo(i,r,a.min,a.max,W),j=M(ue);b(z,F,j),b(z,G,j)}if(!a.spanGaps){let z=[];z.push(...tp(l,c,s,o,A,E,t)),V.gaps=z=a.gaps(i,r,s,o,z),V.clip=Uc(z,h.ori,m,x,_,g)}return K!=0&&(V.band=K==2?[Zr(i,r,s,o,N,-1),Zr(i,r,s,o,N,1)]:Zr(i,r,s,o,N,K)),V})}function J1(n){return Y1(Z1,n)}function Z1(n,e,t,i,r,s){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),f=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],f[d]=n[d+1]-n[d],c[d]=h[d]/f[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(f[d-1]+f[d])/((2*f[d]+f[d-1])/c[d-1]+(f[d]+2*f[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)r(a,n[d]+f[d]/3,e[d]+l[d]*f[d]/3,n[d+1]-f[d]/3,e[d+1]-l[d+1]*f[d]/3,n[d+1],e[d+1])}return a}var zf=new Set;function __(){for(let n of zf)n.syncRect(!0)}qo&&(eo(Pw,Ho,__),eo(Iw,Ho,__,!0),eo(Rc,Ho,()=>{Cn.pxRatio=Ft}));var K1=nx(),j1=ex();function x_(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((s,o)=>Hf(s,o,e,t))}function Q1(n,e){return n.map((t,i)=>i==0?{}:En({},e,t))}function Hf(n,e,t,i){return En({},e==0?t:i,n)}function ix(n,e,t){return e==null?Wo:[e,t]}var eT=ix;function tT(n,e,t){return e==null?Wo:Pc(e,t,qf,!0)}function rx(n,e,t,i){return e==null?Wo:Dc(e,t,n.scales[i].log,!1)}var nT=rx;function sx(n,e,t,i){return e==null?Wo:Xf(e,t,n.scales[i].log,!1)}var iT=sx;function rT(n,e,t,i,r){let s=ci(Z0(n),Z0(e)),o=e-n,a=hr(r/i*o,t);do{let l=t[a],c=i*l/o;if(c>=r&&s+(l<5?Ts.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function y_(n){let e,t;return n=n.replace(/(\d+)px/,(i,r)=>(e=Dn((t=+r)*Ft))+"px"),[n,e,t]}function sT(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=qt(e[2]*Ft,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Cn(n,e,t){let i={mode:Lt(n.mode,1)},r=i.mode;function s(y,w,P,L){let B=w.valToPct(y);return L+P*(w.dir==-1?1-B:B)}function o(y,w,P,L){let B=w.valToPct(y);return L+P*(w.dir==-1?B:1-B)}function a(y,w,P,L){return w.ori==0?s(y,w,P,L):o(y,w,P,L)}i.valToPosH=s,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Yi(dw);if(n.id!=null&&(c.id=n.id),Ai(c,n.class),n.title){let y=Yi(mw,c);y.textContent=n.title}let h=ur("canvas"),f=i.ctx=h.getContext("2d"),d=Yi(gw,c);eo("click",d,y=>{y.target===m&&(jt!=Ro||sn!=Po)&&qn.click(i,y)},!0);let p=i.under=Yi(_w,d);d.appendChild(h);let m=i.over=Yi(xw,d);n=$o(n);let x=+Lt(n.pxAlign,1),_=m_(x);(n.plugins||[]).forEach(y=>{y.opts&&(n=y.opts(i,n)||n)});let g=n.ms||.001,v=i.series=r==1?x_(n.series||[],l_,f_,!1):Q1(n.series||[null],d_),E=i.axes=x_(n.axes||[],a_,u_,!0),M=i.scales={},I=i.bands=n.bands||[];I.forEach(y=>{y.fill=wt(y.fill||null),y.dir=Lt(y.dir,-1)});let C=r==2?v[1].facets[0].scale:v[0].scale,b={axes:Xr,series:vt},A=(n.drawOrder||["axes","series"]).map(y=>b[y]);function G(y){let w=y.distr==3?P=>Jr(P>0?P:y.clamp(i,P,y.min,y.max,y.key)):y.distr==4?P=>Rf(P,y.asinh):y.distr==100?P=>y.fwd(P):P=>P;return P=>{let L=w(P),{_min:B,_max:Z}=y,le=Z-B;return(L-B)/le}}function F(y){let w=M[y];if(w==null){let P=(n.scales||nl)[y]||nl;if(P.from!=null){F(P.from);let L=En({},M[P.from],P,{key:y});L.valToPct=G(L),M[y]=L}else{w=M[y]=En({},y==C?q_:z1,P),w.key=y;let L=w.time,B=w.range,Z=ws(B);if((y!=C||r==2&&!L)&&(Z&&(B[0]==null||B[1]==null)&&(B={min:B[0]==null?q0:{mode:1,hard:B[0],soft:B[0]},max:B[1]==null?q0:{mode:1,hard:B[1],soft:B[1]}},Z=!1),!Z&&Fc(B))){let le=B;B=(pe,Se,Fe)=>Se==null?Wo:Pc(Se,Fe,le)}w.range=wt(B||(L?eT:y==C?w.distr==3?nT:w.distr==4?iT:ix:w.distr==3?rx:w.distr==4?sx:tT)),w.auto=wt(Z?!1:w.auto),w.clamp=wt(w.clamp||V1),w._min=w._max=null,w.valToPct=G(w)}}}F("x"),F("y"),r==1&&v.forEach(y=>{F(y.scale)}),E.forEach(y=>{F(y.scale)});for(let y in n.scales)F(y);let D=M[C],H=D.distr,V,N;D.ori==0?(Ai(c,fw),V=s,N=o):(Ai(c,pw),V=o,N=s);let W={};for(let y in M){let w=M[y];(w.min!=null||w.max!=null)&&(W[y]={min:w.min,max:w.max},w.min=w.max=null)}let K=n.tzDate||(y=>new Date(Dn(y/g))),z=n.fmtDate||Zf,ue=g==1?f1(K):g1(K),j=r_(K,i_(g==1?d1:m1,z)),ee=o_(K,s_(x1,z)),se=[],fe=i.legend=En({},b1,n.legend),de=i.cursor=En({},E1,{drag:{y:r==2}},n.cursor),te=fe.show,_e=de.show,ve=fe.markers;fe.idxs=se,ve.width=wt(ve.width),ve.dash=wt(ve.dash),ve.stroke=wt(ve.stroke),ve.fill=wt(ve.fill);let Re,we,qe,ct=[],$e=[],_t,ft=!1,at={};if(fe.live){let y=v[1]?v[1].values:null;ft=y!=null,_t=ft?y(i,1,0):{_:0};for(let w in _t)at[w]=Wf}if(te)if(Re=ur("table",ww,c),qe=ur("tbody",null,Re),fe.mount(i,Re),ft){we=ur("thead",null,Re,qe);let y=ur("tr",null,we);ur("th",null,y);for(var rn in _t)ur("th",N0,y).textContent=rn}else Ai(Re,Aw),fe.live&&Ai(Re,Tw);let Yt={show:!0},yn={show:!1};function Gt(y,w){if(w==0&&(ft||!fe.live||r==2))return Wo;let P=[],L=ur("tr",Ew,qe,qe.childNodes[w]);Ai(L,y.class),y.show||Ai(L,Qs);let B=ur("th",null,L);if(ve.show){let pe=Yi(Cw,B);if(w>0){let Se=ve.width(i,w);Se&&(pe.style.border=Se+"px "+ve.dash(i,w)+" "+ve.stroke(i,w)),pe.style.background=ve.fill(i,w)}}let Z=Yi(N0,B);y.label instanceof HTMLElement?Z.appendChild(y.label):Z.textContent=y.label,w>0&&(ve.show||(Z.style.color=y.width>0?ve.stroke(i,w):ve.fill(i,w)),At("click",B,pe=>{if(de._lock)return;tt(pe);let Se=v.indexOf(y);if((pe.ctrlKey||pe.metaKey)!=fe.isolate){let Fe=v.some((ke,Ve)=>Ve>0&&Ve!=Se&&ke.show);v.forEach((ke,Ve)=>{Ve>0&&wr(Ve,Fe?Ve==Se?Yt:yn:Yt,!0,wn.setSeries)})}else wr(Se,{show:!y.show},!0,wn.setSeries)},!1),nt&&At(O0,B,pe=>{de._lock||(tt(pe),wr(v.indexOf(y),Lo,!0,wn.setSeries))},!1));for(var le in _t){let pe=ur("td",Rw,L);pe.textContent="--",P.push(pe)}return[L,P]}let On=new Map;function At(y,w,P,L=!0){let B=On.get(w)||{},Z=de.bind[y](i,w,P,L);Z&&(eo(y,w,B[y]=Z),On.set(w,B))}function Pn(y,w,P){let L=On.get(w)||{};for(let B in L)(y==null||B==y)&&(Uf(B,w,L[B]),delete L[B]);y==null&&On.delete(w)}let cn=0,vn=0,k=0,Ie=0,Ze=0,ut=0,Te=Ze,$t=ut,We=k,Je=Ie,R=0,S=0,$=0,he=0;i.bbox={};let ae=!1,ye=!1,be=!1,ne=!1,re=!1,me=!1;function U(y,w,P){(P||y!=i.width||w!=i.height)&&oe(y,w),pt(!1),be=!0,ye=!0,Kn()}function oe(y,w){i.width=cn=k=y,i.height=vn=Ie=w,Ze=ut=0,Me(),Xe();let P=i.bbox;R=P.left=Ks(Ze*Ft,.5),S=P.top=Ks(ut*Ft,.5),$=P.width=Ks(k*Ft,.5),he=P.height=Ks(Ie*Ft,.5)}let ie=3;function Ae(){let y=!1,w=0;for(;!y;){w++;let P=Ao(w),L=Mr(w);y=w==ie||P&&L,y||(oe(i.width,i.height),ye=!0)}}function xe({width:y,height:w}){U(y,w)}i.setSize=xe;function Me(){let y=!1,w=!1,P=!1,L=!1;E.forEach((B,Z)=>{if(B.show&&B._show){let{side:le,_size:pe}=B,Se=le%2,Fe=B.label!=null?B.labelSize:0,ke=pe+Fe;ke>0&&(Se?(k-=ke,le==3?(Ze+=ke,L=!0):P=!0):(Ie-=ke,le==0?(ut+=ke,y=!0):w=!0))}}),br[0]=y,br[1]=P,br[2]=w,br[3]=L,k-=ir[1]+ir[3],Ze+=ir[3],Ie-=ir[2]+ir[0],ut+=ir[0]}function Xe(){let y=Ze+k,w=ut+Ie,P=Ze,L=ut;function B(Z,le){switch(Z){case 1:return y+=le,y-le;case 2:return w+=le,w-le;case 3:return P-=le,P+le;case 0:return L-=le,L+le}}E.forEach((Z,le)=>{if(Z.show&&Z._show){let pe=Z.side;Z._pos=B(pe,Z._size),Z.label!=null&&(Z._lpos=B(pe,Z.labelSize))}})}if(de.dataIdx==null){let y=de.hover,w=y.skip=new Set(y.skip??[]);w.add(void 0);let P=y.prox=wt(y.prox),L=y.bias??=0;de.dataIdx=(B,Z,le,pe)=>{if(Z==0)return le;let Se=le,Fe=P(B,Z,le,pe)??Xt,ke=Fe>=0&&Fe<Xt,Ve=D.ori==0?k:Ie,lt=de.left,Dt=e[0],It=e[Z];if(w.has(It[le])){Se=null;let St=null,Qe=null,Ye;if(L==0||L==-1)for(Ye=le;St==null&&Ye-- >0;)w.has(It[Ye])||(St=Ye);if(L==0||L==1)for(Ye=le;Qe==null&&Ye++<It.length;)w.has(It[Ye])||(Qe=Ye);if(St!=null||Qe!=null)if(ke){let en=St==null?-1/0:V(Dt[St],D,Ve,0),dn=Qe==null?1/0:V(Dt[Qe],D,Ve,0),Hn=lt-en,Wt=dn-lt;Hn<=Wt?Hn<=Fe&&(Se=St):Wt<=Fe&&(Se=Qe)}else Se=Qe==null?St:St==null?Qe:le-St<=Qe-le?St:Qe}else ke&&Nn(lt-V(Dt[le],D,Ve,0))>Fe&&(Se=null);return Se}}let tt=y=>{de.event=y};de.idxs=se,de._lock=!1;let ce=de.points;ce.show=wt(ce.show),ce.size=wt(ce.size),ce.stroke=wt(ce.stroke),ce.width=wt(ce.width),ce.fill=wt(ce.fill);let ze=i.focus=En({},n.focus||{alpha:.3},de.focus),nt=ze.prox>=0,Pe=nt&&ce.one,ht=[],Kt=[],ii=[];function Ua(y,w){let P=ce.show(i,w);if(P instanceof HTMLElement)return Ai(P,Mw),Ai(P,y.class),Ir(P,-10,-10,k,Ie),m.insertBefore(P,ht[w]),P}function Mo(y,w){if(r==1||w>0){let P=r==1&&M[y.scale].time,L=y.value;y.value=P?Q0(L)?o_(K,s_(L,z)):L||ee:L||k1,y.label=y.label||(P?R1:C1)}if(Pe||w>0){y.width=y.width==null?1:y.width,y.paths=y.paths||K1||zw,y.fillTo=wt(y.fillTo||H1),y.pxAlign=+Lt(y.pxAlign,x),y.pxRound=m_(y.pxAlign),y.stroke=wt(y.stroke||null),y.fill=wt(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let P=O1(ci(1,y.width),1),L=y.points=En({},{size:P,width:ci(1,P*.2),stroke:y.stroke,space:P*2,paths:j1,_stroke:null,_fill:null},y.points);L.show=wt(L.show),L.filter=wt(L.filter),L.fill=wt(L.fill),L.stroke=wt(L.stroke),L.paths=wt(L.paths),L.pxAlign=y.pxAlign}if(te){let P=Gt(y,w);ct.splice(w,0,P[0]),$e.splice(w,0,P[1]),fe.values.push(null)}if(_e){se.splice(w,0,null);let P=null;Pe?w==0&&(P=Ua(y,w)):w>0&&(P=Ua(y,w)),ht.splice(w,0,P),Kt.splice(w,0,0),ii.splice(w,0,0)}zn("addSeries",w)}function Jd(y,w){w=w??v.length,y=r==1?Hf(y,w,l_,f_):Hf(y,w,{},d_),v.splice(w,0,y),Mo(v[w],w)}i.addSeries=Jd;function nc(y){if(v.splice(y,1),te){fe.values.splice(y,1),$e.splice(y,1);let w=ct.splice(y,1)[0];Pn(null,w.firstChild),w.remove()}_e&&(se.splice(y,1),ht.splice(y,1)[0].remove(),Kt.splice(y,1),ii.splice(y,1)),zn("delSeries",y)}i.delSeries=nc;let br=[!1,!1,!1,!1];function Gr(y,w){if(y._show=y.show,y.show){let P=y.side%2,L=M[y.scale];L==null&&(y.scale=P?v[1].scale:C,L=M[y.scale]);let B=L.time;y.size=wt(y.size),y.space=wt(y.space),y.rotate=wt(y.rotate),ws(y.incrs)&&y.incrs.forEach(le=>{!Ts.has(le)&&Ts.set(le,C_(le))}),y.incrs=wt(y.incrs||(L.distr==2?c1:B?g==1?h1:p1:js)),y.splits=wt(y.splits||(B&&L.distr==1?ue:L.distr==3?Of:L.distr==4?L1:I1)),y.stroke=wt(y.stroke),y.grid.stroke=wt(y.grid.stroke),y.ticks.stroke=wt(y.ticks.stroke),y.border.stroke=wt(y.border.stroke);let Z=y.values;y.values=ws(Z)&&!ws(Z[0])?wt(Z):B?ws(Z)?r_(K,i_(Z,z)):Q0(Z)?_1(K,Z):Z||j:Z||P1,y.filter=wt(y.filter||(L.distr>=3&&L.log==10?F1:L.distr==3&&L.log==2?U1:A_)),y.font=y_(y.font),y.labelFont=y_(y.labelFont),y._size=y.size(i,null,w,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(br[w]=!0,y._el=Yi(yw,d))}}function Wr(y,w,P,L){let[B,Z,le,pe]=P,Se=w%2,Fe=0;return Se==0&&(pe||Z)&&(Fe=w==0&&!B||w==2&&!le?Dn(a_.size/3):0),Se==1&&(B||le)&&(Fe=w==1&&!Z||w==3&&!pe?Dn(u_.size/2):0),Fe}let ka=i.padding=(n.padding||[Wr,Wr,Wr,Wr]).map(y=>wt(Lt(y,Wr))),ir=i._padding=ka.map((y,w)=>y(i,w,br,0)),un,mn=null,gn=null,Sr=r==1?v[0].idxs:null,vi=null,ps=!1;function Oa(y,w){if(e=y??[],i.data=i._data=e,r==2){un=0;for(let P=1;P<v.length;P++)un+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),vi=e[0],un=vi.length;let P=e;if(H==2){P=e.slice();let L=P[0]=Array(un);for(let B=0;B<un;B++)L[B]=B}i._data=e=P}if(pt(!0),zn("setData"),H==2&&(be=!0),w!==!1){let P=D;P.auto(i,ps)?Ba():_s(C,P.min,P.max),ne=ne||de.left>=0,me=!0,Kn()}}i.setData=Oa;function Ba(){ps=!0;let y,w;r==1&&(un>0?(mn=Sr[0]=0,gn=Sr[1]=un-1,y=e[0][mn],w=e[0][gn],H==2?(y=mn,w=gn):y==w&&(H==3?[y,w]=Dc(y,y,D.log,!1):H==4?[y,w]=Xf(y,y,D.log,!1):D.time?w=y+Dn(86400/g):[y,w]=Pc(y,w,qf,!0))):(mn=Sr[0]=y=null,gn=Sr[1]=w=null)),_s(C,y,w)}let wo,ms,To,T,O,Q,q,Y,Ee,Le;function Ce(y,w,P,L,B,Z){y??=U0,P??=Jf,L??="butt",B??=U0,Z??="round",y!=wo&&(f.strokeStyle=wo=y),B!=ms&&(f.fillStyle=ms=B),w!=To&&(f.lineWidth=To=w),Z!=O&&(f.lineJoin=O=Z),L!=Q&&(f.lineCap=Q=L),P!=T&&f.setLineDash(T=P)}function De(y,w,P,L){w!=ms&&(f.fillStyle=ms=w),y!=q&&(f.font=q=y),P!=Y&&(f.textAlign=Y=P),L!=Ee&&(f.textBaseline=Ee=L)}function Ge(y,w,P,L,B=0){if(L.length>0&&y.auto(i,ps)&&(w==null||w.min==null)){let Z=Lt(mn,0),le=Lt(gn,L.length-1),pe=P.min==null?Fw(L,Z,le,B,y.distr==3):[P.min,P.max];y.min=dr(y.min,P.min=pe[0]),y.max=ci(y.max,P.max=pe[1])}}let rt={min:null,max:null};function yt(){for(let L in M){let B=M[L];W[L]==null&&(B.min==null||W[C]!=null&&B.auto(i,ps))&&(W[L]=rt)}for(let L in M){let B=M[L];W[L]==null&&B.from!=null&&W[B.from]!=null&&(W[L]=rt)}W[C]!=null&&pt(!0);let y={};for(let L in W){let B=W[L];if(B!=null){let Z=y[L]=$o(M[L],Ww);if(B.min!=null)En(Z,B);else if(L!=C||r==2)if(un==0&&Z.from==null){let le=Z.range(i,null,null,L);Z.min=le[0],Z.max=le[1]}else Z.min=Xt,Z.max=-Xt}}if(un>0){v.forEach((L,B)=>{if(r==1){let Z=L.scale,le=W[Z];if(le==null)return;let pe=y[Z];if(B==0){let Se=pe.range(i,pe.min,pe.max,Z);pe.min=Se[0],pe.max=Se[1],mn=hr(pe.min,e[0]),gn=hr(pe.max,e[0]),gn-mn>1&&(e[0][mn]<pe.min&&mn++,e[0][gn]>pe.max&&gn--),L.min=vi[mn],L.max=vi[gn]}else L.show&&L.auto&&Ge(pe,le,L,e[B],L.sorted);L.idxs[0]=mn,L.idxs[1]=gn}else if(B>0&&L.show&&L.auto){let[Z,le]=L.facets,pe=Z.scale,Se=le.scale,[Fe,ke]=e[B],Ve=y[pe],lt=y[Se];Ve!=null&&Ge(Ve,W[pe],Z,Fe,Z.sorted),lt!=null&&Ge(lt,W[Se],le,ke,le.sorted),L.min=le.min,L.max=le.max}});for(let L in y){let B=y[L],Z=W[L];if(B.from==null&&(Z==null||Z.min==null)){let le=B.range(i,B.min==Xt?null:B.min,B.max==-Xt?null:B.max,L);B.min=le[0],B.max=le[1]}}}for(let L in y){let B=y[L];if(B.from!=null){let Z=y[B.from];if(Z.min==null)B.min=B.max=null;else{let le=B.range(i,Z.min,Z.max,L);B.min=le[0],B.max=le[1]}}}let w={},P=!1;for(let L in y){let B=y[L],Z=M[L];if(Z.min!=B.min||Z.max!=B.max){Z.min=B.min,Z.max=B.max;let le=Z.distr;Z._min=le==3?Jr(Z.min):le==4?Rf(Z.min,Z.asinh):le==100?Z.fwd(Z.min):Z.min,Z._max=le==3?Jr(Z.max):le==4?Rf(Z.max,Z.asinh):le==100?Z.fwd(Z.max):Z.max,w[L]=P=!0}}if(P){v.forEach((L,B)=>{r==2?B>0&&w.y&&(L._paths=null):w[L.scale]&&(L._paths=null)});for(let L in w)be=!0,zn("setScale",L);_e&&de.left>=0&&(ne=me=!0)}for(let L in W)W[L]=null}function He(y){let w=kf(mn-1,0,un-1),P=kf(gn+1,0,un-1);for(;y[w]==null&&w>0;)w--;for(;y[P]==null&&P<un-1;)P++;return[w,P]}function vt(){if(un>0){let y=v.some(w=>w._focus)&&Le!=ze.alpha;y&&(f.globalAlpha=Le=ze.alpha),v.forEach((w,P)=>{if(P>0&&w.show&&(on(P,!1),on(P,!0),w._paths==null)){let L=Le;Le!=w.alpha&&(f.globalAlpha=Le=w.alpha);let B=r==2?[0,e[P][0].length-1]:He(e[P]);w._paths=w.paths(i,P,B[0],B[1]),Le!=L&&(f.globalAlpha=Le=L)}}),v.forEach((w,P)=>{if(P>0&&w.show){let L=Le;Le!=w.alpha&&(f.globalAlpha=Le=w.alpha),w._paths!=null&&Ot(P,!1);{let B=w._paths!=null?w._paths.gaps:null,Z=w.points.show(i,P,mn,gn,B),le=w.points.filter(i,P,Z,B);(Z||le)&&(w.points._paths=w.points.paths(i,P,mn,gn,le),Ot(P,!0))}Le!=L&&(f.globalAlpha=Le=L),zn("drawSeries",P)}}),y&&(f.globalAlpha=Le=1)}}function on(y,w){let P=w?v[y].points:v[y];P._stroke=P.stroke(i,y),P._fill=P.fill(i,y)}function Ot(y,w){let P=w?v[y].points:v[y],{stroke:L,fill:B,clip:Z,flags:le,_stroke:pe=P._stroke,_fill:Se=P._fill,_width:Fe=P.width}=P._paths;Fe=qt(Fe*Ft,3);let ke=null,Ve=Fe%2/2;w&&Se==null&&(Se=Fe>0?"#fff":pe);let lt=P.pxAlign==1&&Ve>0;if(lt&&f.translate(Ve,Ve),!w){let Dt=R-Fe/2,It=S-Fe/2,St=$+Fe,Qe=he+Fe;ke=new Path2D,ke.rect(Dt,It,St,Qe)}w?Be(pe,Fe,P.dash,P.cap,Se,L,B,le,Z):Bt(y,pe,Fe,P.dash,P.cap,Se,L,B,le,ke,Z),lt&&f.translate(-Ve,-Ve)}function Bt(y,w,P,L,B,Z,le,pe,Se,Fe,ke){let Ve=!1;Se!=0&&I.forEach((lt,Dt)=>{if(lt.series[0]==y){let It=v[lt.series[1]],St=e[lt.series[1]],Qe=(It._paths||nl).band;ws(Qe)&&(Qe=lt.dir==1?Qe[0]:Qe[1]);let Ye,en=null;It.show&&Qe&&kw(St,mn,gn)?(en=lt.fill(i,Dt)||Z,Ye=It._paths.clip):Qe=null,Be(w,P,L,B,en,le,pe,Se,Fe,ke,Ye,Qe),Ve=!0}}),Ve||Be(w,P,L,B,Z,le,pe,Se,Fe,ke)}let In=Xo|Vf;function Be(y,w,P,L,B,Z,le,pe,Se,Fe,ke,Ve){Ce(y,w,P,L,B),(Se||Fe||Ve)&&(f.save(),Se&&f.clip(Se),Fe&&f.clip(Fe)),Ve?(pe&In)==In?(f.clip(Ve),ke&&f.clip(ke),Mt(B,le),bn(y,Z,w)):pe&Vf?(Mt(B,le),f.clip(Ve),bn(y,Z,w)):pe&Xo&&(f.save(),f.clip(Ve),ke&&f.clip(ke),Mt(B,le),f.restore(),bn(y,Z,w)):(Mt(B,le),bn(y,Z,w)),(Se||Fe||Ve)&&f.restore()}function bn(y,w,P){P>0&&(w instanceof Map?w.forEach((L,B)=>{f.strokeStyle=wo=B,f.stroke(L)}):w!=null&&y&&f.stroke(w))}function Mt(y,w){w instanceof Map?w.forEach((P,L)=>{f.fillStyle=ms=L,f.fill(P)}):w!=null&&y&&f.fill(w)}function $r(y,w,P,L){let B=E[y],Z;if(L<=0)Z=[0,0];else{let le=B._space=B.space(i,y,w,P,L),pe=B._incrs=B.incrs(i,y,w,P,L,le);Z=rT(w,P,pe,L,le)}return B._found=Z}function Sn(y,w,P,L,B,Z,le,pe,Se,Fe){let ke=le%2/2;x==1&&f.translate(ke,ke),Ce(pe,le,Se,Fe,pe),f.beginPath();let Ve,lt,Dt,It,St=B+(L==0||L==3?-Z:Z);P==0?(lt=B,It=St):(Ve=B,Dt=St);for(let Qe=0;Qe<y.length;Qe++)w[Qe]!=null&&(P==0?Ve=Dt=y[Qe]:lt=It=y[Qe],f.moveTo(Ve,lt),f.lineTo(Dt,It));f.stroke(),x==1&&f.translate(-ke,-ke)}function Ao(y){let w=!0;return E.forEach((P,L)=>{if(!P.show)return;let B=M[P.scale];if(B.min==null){P._show&&(w=!1,P._show=!1,pt(!1));return}else P._show||(w=!1,P._show=!0,pt(!1));let Z=P.side,le=Z%2,{min:pe,max:Se}=B,[Fe,ke]=$r(L,pe,Se,le==0?k:Ie);if(ke==0)return;let Ve=B.distr==2,lt=P._splits=P.splits(i,L,pe,Se,Fe,ke,Ve),Dt=B.distr==2?lt.map(Ye=>vi[Ye]):lt,It=B.distr==2?vi[lt[1]]-vi[lt[0]]:Fe,St=P._values=P.values(i,P.filter(i,Dt,L,ke,It),L,ke,It);P._rotate=Z==2?P.rotate(i,St,L,ke):0;let Qe=P._size;P._size=Ji(P.size(i,St,L,y)),Qe!=null&&P._size!=Qe&&(w=!1)}),w}function Mr(y){let w=!0;return ka.forEach((P,L)=>{let B=P(i,L,br,y);B!=ir[L]&&(w=!1),ir[L]=B}),w}function Xr(){for(let y=0;y<E.length;y++){let w=E[y];if(!w.show||!w._show)continue;let P=w.side,L=P%2,B,Z,le=w.stroke(i,y),pe=P==0||P==3?-1:1,[Se,Fe]=w._found;if(w.label!=null){let oi=w.labelGap*pe,Mi=Dn((w._lpos+oi)*Ft);De(w.labelFont[0],le,"center",P==2?"top":F0),f.save(),L==1?(B=Z=0,f.translate(Mi,Dn(S+he/2)),f.rotate((P==3?-Cc:Cc)/2)):(B=Dn(R+$/2),Z=Mi);let Xs=w_(w.label)?w.label(i,y,Se,Fe):w.label;f.fillText(Xs,B,Z),f.restore()}if(Fe==0)continue;let ke=M[w.scale],Ve=L==0?$:he,lt=L==0?R:S,Dt=w._splits,It=ke.distr==2?Dt.map(oi=>vi[oi]):Dt,St=ke.distr==2?vi[Dt[1]]-vi[Dt[0]]:Se,Qe=w.ticks,Ye=w.border,en=Qe.show?Qe.size:0,dn=Dn(en*Ft),Hn=Dn((w.alignTo==2?w._size-en-w.gap:w.gap)*Ft),Wt=w._rotate*-Cc/180,fn=_(w._pos*Ft),bi=(dn+Hn)*pe,si=fn+bi;Z=L==0?si:0,B=L==1?si:0;let Wi=w.font[0],rr=w.align==1?Vo:w.align==2?Af:Wt>0?Vo:Wt<0?Af:L==0?"center":P==3?Af:Vo,Ar=Wt||L==1?"middle":P==2?"top":F0;De(Wi,le,rr,Ar);let Si=w.font[1]*w.lineGap,$i=Dt.map(oi=>_(a(oi,ke,Ve,lt))),sr=w._values;for(let oi=0;oi<sr.length;oi++){let Mi=sr[oi];if(Mi!=null){L==0?B=$i[oi]:Z=$i[oi],Mi=""+Mi;let Xs=Mi.indexOf(`
`)==-1?[Mi]:Mi.split(/\n/gm);for(let ai=0;ai<Xs.length;ai++){let Ng=Xs[ai];Wt?(f.save(),f.translate(B,Z+ai*Si),f.rotate(Wt),f.fillText(Ng,0,0),f.restore()):f.fillText(Ng,B,Z+ai*Si)}}}Qe.show&&Sn($i,Qe.filter(i,It,y,Fe,St),L,P,fn,dn,qt(Qe.width*Ft,3),Qe.stroke(i,y),Qe.dash,Qe.cap);let Er=w.grid;Er.show&&Sn($i,Er.filter(i,It,y,Fe,St),L,L==0?2:1,L==0?S:R,L==0?he:$,qt(Er.width*Ft,3),Er.stroke(i,y),Er.dash,Er.cap),Ye.show&&Sn([fn],[1],L==0?1:0,L==0?1:2,L==1?S:R,L==1?he:$,qt(Ye.width*Ft,3),Ye.stroke(i,y),Ye.dash,Ye.cap)}zn("drawAxes")}function pt(y){v.forEach((w,P)=>{P>0&&(w._paths=null,y&&(r==1?(w.min=null,w.max=null):w.facets.forEach(L=>{L.min=null,L.max=null})))})}let hn=!1,ri=!1,Vt=[];function Mn(){ri=!1;for(let y=0;y<Vt.length;y++)zn(...Vt[y]);Vt.length=0}function Kn(){hn||(Kw(gg),hn=!0)}function ic(y,w=!1){hn=!0,ri=w,y(i),gg(),w&&Vt.length>0&&queueMicrotask(Mn)}i.batch=ic;function gg(){if(ae&&(yt(),ae=!1),be&&(Ae(),be=!1),ye){if(tn(p,Vo,Ze),tn(p,"top",ut),tn(p,ja,k),tn(p,Qa,Ie),tn(m,Vo,Ze),tn(m,"top",ut),tn(m,ja,k),tn(m,Qa,Ie),tn(d,ja,cn),tn(d,Qa,vn),h.width=Dn(cn*Ft),h.height=Dn(vn*Ft),E.forEach(({_el:y,_show:w,_size:P,_pos:L,side:B})=>{if(y!=null)if(w){let Z=B===3||B===0?P:0,le=B%2==1;tn(y,le?"left":"top",L-Z),tn(y,le?"width":"height",P),tn(y,le?"top":"left",le?ut:Ze),tn(y,le?"height":"width",le?Ie:k),Ff(y,Qs)}else Ai(y,Qs)}),wo=ms=To=O=Q=q=Y=Ee=T=null,Le=1,Ha(!0),Ze!=Te||ut!=$t||k!=We||Ie!=Je){pt(!1);let y=k/We,w=Ie/Je;if(_e&&!ne&&de.left>=0){de.left*=y,de.top*=w,Eo&&Ir(Eo,Dn(de.left),0,k,Ie),Co&&Ir(Co,0,Dn(de.top),k,Ie);for(let P=0;P<ht.length;P++){let L=ht[P];L!=null&&(Kt[P]*=y,ii[P]*=w,Ir(L,Ji(Kt[P]),Ji(ii[P]),k,Ie))}}if(Qt.show&&!re&&Qt.left>=0&&Qt.width>0){Qt.left*=y,Qt.width*=y,Qt.top*=w,Qt.height*=w;for(let P in tf)tn(Io,P,Qt[P])}Te=Ze,$t=ut,We=k,Je=Ie}zn("setSize"),ye=!1}cn>0&&vn>0&&(f.clearRect(0,0,h.width,h.height),zn("drawClear"),A.forEach(y=>y()),zn("draw")),Qt.show&&re&&(rc(Qt),re=!1),_e&&ne&&($s(null,!0,!1),ne=!1),fe.show&&fe.live&&me&&(Qd(),me=!1),l||(l=!0,i.status=1,zn("ready")),ps=!1,hn=!1}i.redraw=(y,w)=>{be=w||!1,y!==!1?_s(C,D.min,D.max):Kn()};function Zd(y,w){let P=M[y];if(P.from==null){if(un==0){let L=P.range(i,w.min,w.max,y);w.min=L[0],w.max=L[1]}if(w.min>w.max){let L=w.min;w.min=w.max,w.max=L}if(un>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;y==C&&P.distr==2&&un>0&&(w.min=hr(w.min,e[0]),w.max=hr(w.max,e[0]),w.min==w.max&&w.max++),W[y]=w,ae=!0,Kn()}}i.setScale=Zd;let Kd,jd,Eo,Co,_g,xg,Ro,Po,yg,vg,jt,sn,gs=!1,qn=de.drag,Bn=qn.x,Vn=qn.y;_e&&(de.x&&(Kd=Yi(bw,m)),de.y&&(jd=Yi(Sw,m)),D.ori==0?(Eo=Kd,Co=jd):(Eo=jd,Co=Kd),jt=de.left,sn=de.top);let Qt=i.select=En({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Io=Qt.show?Yi(vw,Qt.over?m:p):null;function rc(y,w){if(Qt.show){for(let P in y)Qt[P]=y[P],P in tf&&tn(Io,P,y[P]);w!==!1&&zn("setSelect")}}i.setSelect=rc;function AM(y){if(v[y].show)te&&Ff(ct[y],Qs);else if(te&&Ai(ct[y],Qs),_e){let P=Pe?ht[0]:ht[y];P!=null&&Ir(P,-10,-10,k,Ie)}}function _s(y,w,P){Zd(y,{min:w,max:P})}function wr(y,w,P,L){w.focus!=null&&IM(y),w.show!=null&&v.forEach((B,Z)=>{Z>0&&(y==Z||y==null)&&(B.show=w.show,AM(Z),r==2?(_s(B.facets[0].scale,null,null),_s(B.facets[1].scale,null,null)):_s(B.scale,null,null),Kn())}),P!==!1&&zn("setSeries",y,w),L&&Ga("setSeries",i,y,w)}i.setSeries=wr;function EM(y,w){En(I[y],w)}function CM(y,w){y.fill=wt(y.fill||null),y.dir=Lt(y.dir,-1),w=w??I.length,I.splice(w,0,y)}function RM(y){y==null?I.length=0:I.splice(y,1)}i.addBand=CM,i.setBand=EM,i.delBand=RM;function PM(y,w){v[y].alpha=w,_e&&ht[y]!=null&&(ht[y].style.opacity=w),te&&ct[y]&&(ct[y].style.opacity=w)}let qr,xs,Ws,Lo={focus:!0};function IM(y){if(y!=Ws){let w=y==null,P=ze.alpha!=1;v.forEach((L,B)=>{if(r==1||B>0){let Z=w||B==0||B==y;L._focus=w?null:Z,P&&PM(B,Z?1:ze.alpha)}}),Ws=y,P&&Kn()}}te&&nt&&At(B0,Re,y=>{de._lock||(tt(y),Ws!=null&&wr(null,Lo,!0,wn.setSeries))});function Tr(y,w,P){let L=M[w];P&&(y=y/Ft-(L.ori==1?ut:Ze));let B=k;L.ori==1&&(B=Ie,y=B-y),L.dir==-1&&(y=B-y);let Z=L._min,le=L._max,pe=y/B,Se=Z+(le-Z)*pe,Fe=L.distr;return Fe==3?Go(10,Se):Fe==4?Bw(Se,L.asinh):Fe==100?L.bwd(Se):Se}function LM(y,w){let P=Tr(y,C,w);return hr(P,e[0],mn,gn)}i.valToIdx=y=>hr(y,e[0]),i.posToIdx=LM,i.posToVal=Tr,i.valToPos=(y,w,P)=>M[w].ori==0?s(y,M[w],P?$:k,P?R:0):o(y,M[w],P?he:Ie,P?S:0),i.setCursor=(y,w,P)=>{jt=y.left,sn=y.top,$s(null,w,P)};function bg(y,w){tn(Io,Vo,Qt.left=y),tn(Io,ja,Qt.width=w)}function Sg(y,w){tn(Io,"top",Qt.top=y),tn(Io,Qa,Qt.height=w)}let Va=D.ori==0?bg:Sg,za=D.ori==1?bg:Sg;function DM(){if(te&&fe.live)for(let y=r==2?1:0;y<v.length;y++){if(y==0&&ft)continue;let w=fe.values[y],P=0;for(let L in w)$e[y][P++].firstChild.nodeValue=w[L]}}function Qd(y,w){if(y!=null&&(y.idxs?y.idxs.forEach((P,L)=>{se[L]=P}):Gw(y.idx)||se.fill(y.idx),fe.idx=se[0]),te&&fe.live){for(let P=0;P<v.length;P++)(P>0||r==1&&!ft)&&NM(P,se[P]);DM()}me=!1,w!==!1&&zn("setLegend")}i.setLegend=Qd;function NM(y,w){let P=v[y],L=y==0&&H==2?vi:e[y],B;ft?B=P.values(i,y,w)??at:(B=P.value(i,w==null?null:L[w],y,w),B=B==null?at:{_:B}),fe.values[y]=B}function $s(y,w,P){yg=jt,vg=sn,[jt,sn]=de.move(i,jt,sn),de.left=jt,de.top=sn,_e&&(Eo&&Ir(Eo,Dn(jt),0,k,Ie),Co&&Ir(Co,0,Dn(sn),k,Ie));let L,B=mn>gn;qr=Xt,xs=null;let Z=D.ori==0?k:Ie,le=D.ori==1?k:Ie;if(jt<0||un==0||B){L=de.idx=null;for(let pe=0;pe<v.length;pe++){let Se=ht[pe];Se!=null&&Ir(Se,-10,-10,k,Ie)}nt&&wr(null,Lo,!0,y==null&&wn.setSeries),fe.live&&(se.fill(L),me=!0)}else{let pe,Se,Fe;r==1&&(pe=D.ori==0?jt:sn,Se=Tr(pe,C),L=de.idx=hr(Se,e[0],mn,gn),Fe=V(e[0][L],D,Z,0));let ke=-10,Ve=-10,lt=0,Dt=0,It=!0,St="",Qe="";for(let Ye=r==2?1:0;Ye<v.length;Ye++){let en=v[Ye],dn=se[Ye],Hn=dn==null?null:r==1?e[Ye][dn]:e[Ye][1][dn],Wt=de.dataIdx(i,Ye,L,Se),fn=Wt==null?null:r==1?e[Ye][Wt]:e[Ye][1][Wt];if(me=me||fn!=Hn||Wt!=dn,se[Ye]=Wt,Ye>0&&en.show){let bi=Wt==null?-10:Wt==L?Fe:V(r==1?e[0][Wt]:e[Ye][0][Wt],D,Z,0),si=fn==null?-10:N(fn,r==1?M[en.scale]:M[en.facets[1].scale],le,0);if(nt&&fn!=null){let Wi=D.ori==1?jt:sn,rr=Nn(ze.dist(i,Ye,Wt,si,Wi));if(rr<qr){let Ar=ze.bias;if(Ar!=0){let Si=Tr(Wi,en.scale),$i=fn>=0?1:-1,sr=Si>=0?1:-1;sr==$i&&(sr==1?Ar==1?fn>=Si:fn<=Si:Ar==1?fn<=Si:fn>=Si)&&(qr=rr,xs=Ye)}else qr=rr,xs=Ye}}if(me||Pe){let Wi,rr;D.ori==0?(Wi=bi,rr=si):(Wi=si,rr=bi);let Ar,Si,$i,sr,Er,oi,Mi=!0,Xs=ce.bbox;if(Xs!=null){Mi=!1;let ai=Xs(i,Ye);$i=ai.left,sr=ai.top,Ar=ai.width,Si=ai.height}else $i=Wi,sr=rr,Ar=Si=ce.size(i,Ye);if(oi=ce.fill(i,Ye),Er=ce.stroke(i,Ye),Pe)Ye==xs&&qr<=ze.prox&&(ke=$i,Ve=sr,lt=Ar,Dt=Si,It=Mi,St=oi,Qe=Er);else{let ai=ht[Ye];ai!=null&&(Kt[Ye]=$i,ii[Ye]=sr,X0(ai,Ar,Si,Mi),W0(ai,oi,Er),Ir(ai,Ji($i),Ji(sr),k,Ie))}}}}if(Pe){let Ye=ze.prox,en=Ws==null?qr<=Ye:qr>Ye||xs!=Ws;if(me||en){let dn=ht[0];dn!=null&&(Kt[0]=ke,ii[0]=Ve,X0(dn,lt,Dt,It),W0(dn,St,Qe),Ir(dn,Ji(ke),Ji(Ve),k,Ie))}}}if(Qt.show&&gs)if(y!=null){let[pe,Se]=wn.scales,[Fe,ke]=wn.match,[Ve,lt]=y.cursor.sync.scales,Dt=y.cursor.drag;if(Bn=Dt._x,Vn=Dt._y,Bn||Vn){let{left:It,top:St,width:Qe,height:Ye}=y.select,en=y.scales[Ve].ori,dn=y.posToVal,Hn,Wt,fn,bi,si,Wi=pe!=null&&Fe(pe,Ve),rr=Se!=null&&ke(Se,lt);Wi&&Bn?(en==0?(Hn=It,Wt=Qe):(Hn=St,Wt=Ye),fn=M[pe],bi=V(dn(Hn,Ve),fn,Z,0),si=V(dn(Hn+Wt,Ve),fn,Z,0),Va(dr(bi,si),Nn(si-bi))):Va(0,Z),rr&&Vn?(en==1?(Hn=It,Wt=Qe):(Hn=St,Wt=Ye),fn=M[Se],bi=N(dn(Hn,lt),fn,le,0),si=N(dn(Hn+Wt,lt),fn,le,0),za(dr(bi,si),Nn(si-bi))):za(0,le)}else nf()}else{let pe=Nn(yg-_g),Se=Nn(vg-xg);if(D.ori==1){let lt=pe;pe=Se,Se=lt}Bn=qn.x&&pe>=qn.dist,Vn=qn.y&&Se>=qn.dist;let Fe=qn.uni;Fe!=null?Bn&&Vn&&(Bn=pe>=Fe,Vn=Se>=Fe,!Bn&&!Vn&&(Se>pe?Vn=!0:Bn=!0)):qn.x&&qn.y&&(Bn||Vn)&&(Bn=Vn=!0);let ke,Ve;Bn&&(D.ori==0?(ke=Ro,Ve=jt):(ke=Po,Ve=sn),Va(dr(ke,Ve),Nn(Ve-ke)),Vn||za(0,le)),Vn&&(D.ori==1?(ke=Ro,Ve=jt):(ke=Po,Ve=sn),za(dr(ke,Ve),Nn(Ve-ke)),Bn||Va(0,Z)),!Bn&&!Vn&&(Va(0,0),za(0,0))}if(qn._x=Bn,qn._y=Vn,y==null){if(P){if(Dg!=null){let[pe,Se]=wn.scales;wn.values[0]=pe!=null?Tr(D.ori==0?jt:sn,pe):null,wn.values[1]=Se!=null?Tr(D.ori==1?jt:sn,Se):null}Ga(Ef,i,jt,sn,k,Ie,L)}if(nt){let pe=P&&wn.setSeries,Se=ze.prox;Ws==null?qr<=Se&&wr(xs,Lo,!0,pe):qr>Se?wr(null,Lo,!0,pe):xs!=Ws&&wr(xs,Lo,!0,pe)}}me&&(fe.idx=L,Qd()),w!==!1&&zn("setCursor")}let ys=null;Object.defineProperty(i,"rect",{get(){return ys==null&&Ha(!1),ys}});function Ha(y=!1){y?ys=null:(ys=m.getBoundingClientRect(),zn("syncRect",ys))}function Mg(y,w,P,L,B,Z,le){de._lock||gs&&y!=null&&y.movementX==0&&y.movementY==0||(ef(y,w,P,L,B,Z,le,!1,y!=null),y!=null?$s(null,!0,!0):$s(w,!0,!1))}function ef(y,w,P,L,B,Z,le,pe,Se){if(ys==null&&Ha(!1),tt(y),y!=null)P=y.clientX-ys.left,L=y.clientY-ys.top;else{if(P<0||L<0){jt=-10,sn=-10;return}let[Fe,ke]=wn.scales,Ve=w.cursor.sync,[lt,Dt]=Ve.values,[It,St]=Ve.scales,[Qe,Ye]=wn.match,en=w.axes[0].side%2==1,dn=D.ori==0?k:Ie,Hn=D.ori==1?k:Ie,Wt=en?Z:B,fn=en?B:Z,bi=en?L:P,si=en?P:L;if(It!=null?P=Qe(Fe,It)?a(lt,M[Fe],dn,0):-10:P=dn*(bi/Wt),St!=null?L=Ye(ke,St)?a(Dt,M[ke],Hn,0):-10:L=Hn*(si/fn),D.ori==1){let Wi=P;P=L,L=Wi}}Se&&(w==null||w.cursor.event.type==Ef)&&((P<=1||P>=k-1)&&(P=Ks(P,k)),(L<=1||L>=Ie-1)&&(L=Ks(L,Ie))),pe?(_g=P,xg=L,[Ro,Po]=de.move(i,P,L)):(jt=P,sn=L)}let tf={width:0,height:0,left:0,top:0};function nf(){rc(tf,!1)}let wg,Tg,Ag,Eg;function Cg(y,w,P,L,B,Z,le){gs=!0,Bn=Vn=qn._x=qn._y=!1,ef(y,w,P,L,B,Z,le,!0,!1),y!=null&&(At(Cf,Df,Rg,!1),Ga(k0,i,Ro,Po,k,Ie,null));let{left:pe,top:Se,width:Fe,height:ke}=Qt;wg=pe,Tg=Se,Ag=Fe,Eg=ke}function Rg(y,w,P,L,B,Z,le){gs=qn._x=qn._y=!1,ef(y,w,P,L,B,Z,le,!1,!0);let{left:pe,top:Se,width:Fe,height:ke}=Qt,Ve=Fe>0||ke>0,lt=wg!=pe||Tg!=Se||Ag!=Fe||Eg!=ke;if(Ve&&lt&&rc(Qt),qn.setScale&&Ve&&lt){let Dt=pe,It=Fe,St=Se,Qe=ke;if(D.ori==1&&(Dt=Se,It=ke,St=pe,Qe=Fe),Bn&&_s(C,Tr(Dt,C),Tr(Dt+It,C)),Vn)for(let Ye in M){let en=M[Ye];Ye!=C&&en.from==null&&en.min!=Xt&&_s(Ye,Tr(St+Qe,Ye),Tr(St,Ye))}nf()}else de.lock&&(de._lock=!de._lock,$s(w,!0,y!=null));y!=null&&(Pn(Cf,Df),Ga(Cf,i,jt,sn,k,Ie,null))}function FM(y,w,P,L,B,Z,le){if(de._lock)return;tt(y);let pe=gs;if(gs){let Se=!0,Fe=!0,ke=10,Ve,lt;D.ori==0?(Ve=Bn,lt=Vn):(Ve=Vn,lt=Bn),Ve&&lt&&(Se=jt<=ke||jt>=k-ke,Fe=sn<=ke||sn>=Ie-ke),Ve&&Se&&(jt=jt<Ro?0:k),lt&&Fe&&(sn=sn<Po?0:Ie),$s(null,!0,!0),gs=!1}jt=-10,sn=-10,se.fill(null),$s(null,!0,!0),pe&&(gs=pe)}function Pg(y,w,P,L,B,Z,le){de._lock||(tt(y),Ba(),nf(),y!=null&&Ga(V0,i,jt,sn,k,Ie,null))}function Ig(){E.forEach(sT),U(i.width,i.height,!0)}eo(Rc,Ho,Ig);let Do={};Do.mousedown=Cg,Do.mousemove=Mg,Do.mouseup=Rg,Do.dblclick=Pg,Do.setSeries=(y,w,P,L)=>{let B=wn.match[2];P=B(i,w,P),P!=-1&&wr(P,L,!0,!1)},_e&&(At(k0,m,Cg),At(Ef,m,Mg),At(O0,m,y=>{tt(y),Ha(!1)}),At(B0,m,FM),At(V0,m,Pg),zf.add(i),i.syncRect=Ha);let sc=i.hooks=n.hooks||{};function zn(y,w,P){ri?Vt.push([y,w,P]):y in sc&&sc[y].forEach(L=>{L.call(null,i,w,P)})}(n.plugins||[]).forEach(y=>{for(let w in y.hooks)sc[w]=(sc[w]||[]).concat(y.hooks[w])});let Lg=(y,w,P)=>P,wn=En({key:null,setSeries:!1,filters:{pub:K0,sub:K0},scales:[C,v[1]?v[1].scale:null],match:[j0,j0,Lg],values:[null,null]},de.sync);wn.match.length==2&&wn.match.push(Lg),de.sync=wn;let Dg=wn.key,rf=Y_(Dg);function Ga(y,w,P,L,B,Z,le){wn.filters.pub(y,w,P,L,B,Z,le)&&rf.pub(y,w,P,L,B,Z,le)}rf.sub(i);function UM(y,w,P,L,B,Z,le){wn.filters.sub(y,w,P,L,B,Z,le)&&Do[y](null,w,P,L,B,Z,le)}i.pub=UM;function kM(){rf.unsub(i),zf.delete(i),On.clear(),Uf(Rc,Ho,Ig),c.remove(),Re?.remove(),zn("destroy")}i.destroy=kM;function sf(){zn("init",n,e),Oa(e||n.data,!1),W[C]?Zd(C,W[C]):Ba(),re=Qt.show&&(Qt.width>0||Qt.height>0),ne=me=!0,U(n.width,n.height)}return v.forEach(Mo),E.forEach(Gr),t?t instanceof HTMLElement?(t.appendChild(c),sf()):t(i,sf):sf(),i}Cn.assign=En;Cn.fmtNum=Yf;Cn.rangeNum=Pc;Cn.rangeLog=Dc;Cn.rangeAsinh=Xf;Cn.orient=no;Cn.pxRatio=Ft;Cn.join=Zw;Cn.fmtDate=Zf,Cn.tzDate=a1;Cn.sync=Y_;{Cn.addGap=G1,Cn.clipGaps=Uc;let n=Cn.paths={points:ex};n.linear=nx,n.stepped=X1,n.bars=q1,n.spline=J1}var ox=7;function oT(n,e,t){let{left:i,width:r}=n.bbox;e.forEach((s,o)=>{if(s.faint)return;let a=n.data[o+1];for(let l=0;l<ox;++l){let c=i+r*(l+(o+1)/(e.length+1))/ox,h=n.posToIdx(c,!0);for(;h<a.length&&a[h]==null;)++h;let f=a[h];if(f==null)continue;let d=n.valToPos(n.data[0][h],"x",!0);d<=i+r&&A0(n.ctx,s.style,d,n.valToPos(f,"y",!0),t)}})}function aT(n,e,t,i){if(e.allowed==null||!(e.allowed>0))return;let{left:r,width:s,top:o,height:a}=n.bbox,l=n.valToPos(e.allowed,"y",!0);l<o||l>o+a||(n.ctx.strokeStyle=n.ctx.fillStyle=jn(Ti(e.style).color),n.ctx.lineWidth=1.5*t,n.ctx.setLineDash([3*t,3*t]),n.ctx.beginPath(),n.ctx.moveTo(r,l),n.ctx.lineTo(r+s,l),n.ctx.stroke(),n.ctx.setLineDash([]),n.ctx.font=`${11*t}px system-ui, sans-serif`,n.ctx.textAlign="right",n.ctx.fillText(i,r+s-4*t,l-4*t))}function lT(n,e,t){if(!e.violation)return;let{left:i,width:r,top:s,height:o}=n.bbox,a=n.valToPos(e.violation.time,"x",!0);if(a<i||a>i+r)return;let{value:l}=e.violation,c=l===null?s:Math.min(s+o,Math.max(s,n.valToPos(l,"y",!0)));n.ctx.strokeStyle=jn("--ink"),n.ctx.lineWidth=2*t,n.ctx.beginPath(),n.ctx.arc(a,c,7*t,0,2*Math.PI),n.ctx.moveTo(a-4*t,c-4*t),n.ctx.lineTo(a+4*t,c+4*t),n.ctx.moveTo(a-4*t,c+4*t),n.ctx.lineTo(a+4*t,c-4*t),n.ctx.stroke()}function ax(n,e){let{left:t,top:i,width:r,height:s}=n.bbox;n.ctx.save(),n.ctx.beginPath(),n.ctx.rect(t,i,r,s),n.ctx.clip();for(let{band:o,time:a,style:l}of e)if(!(!o||a.length===0)){n.ctx.fillStyle=jn(Ti(l).color),n.ctx.globalAlpha=.22,n.ctx.beginPath();for(let c=0;c<a.length;++c)n.ctx.lineTo(n.valToPos(a[c],"x",!0),n.valToPos(o.high[c],"y",!0));for(let c=a.length-1;c>=0;--c)n.ctx.lineTo(n.valToPos(a[c],"x",!0),n.valToPos(o.low[c],"y",!0));n.ctx.closePath(),n.ctx.fill()}n.ctx.restore()}function lx(n,e,t){let i=devicePixelRatio;n.ctx.save();let r=new Set;for(let s of e)s.allowed==null||r.has(s.allowed)||(r.add(s.allowed),aT(n,s,i,t(s.allowed)));oT(n,e,i);for(let s of e)lT(n,s,i);n.ctx.restore()}var cx=Array.from({length:130},(n,e)=>e-50).flatMap(n=>[1,2,5].map(e=>+`${e}e${n}`));function cT(n){let e={stroke:()=>jn("--ink"),grid:{stroke:()=>jn("--line"),width:1},ticks:{stroke:()=>jn("--line"),width:1},font:"12px system-ui, sans-serif",labelFont:"12px system-ui, sans-serif",labelSize:18,labelGap:0},t=(i,r)=>r.map(s=>s===null?"":n.number(s));return[{...e,label:"time [s]",values:t,incrs:cx,size:34},{...e,label:n.axis,values:t,incrs:cx,size:64,...n.log?{splits:fT,filter:(i,r)=>r}:{}}]}function uT(n,e,t){let i=Math.floor(Math.log10(e));return[10**i,10**Math.max(i+1,Math.ceil(Math.log10(t)))]}var hT=680,dT=22;function fT(n,e,t,i){let[r,s]=[Math.round(Math.log10(t)),Math.round(Math.log10(i))],o=Math.max(2,n.bbox.height/devicePixelRatio/dT),a=Math.ceil((s-r)/o),l=3*(s-r)<=o?[1,2,5]:[1],c=[];for(let h=r;h<=s;h+=a)for(let f of l)c.push(f*10**h);return c.filter(h=>h<=i)}function ux(n,e){return n==null||e==null?[-1,1]:n===e?[n-(Math.abs(n)||1),n+(Math.abs(n)||1)]:Cn.rangeNum(n,e,.1,!0)}function pT(n,e){let{curves:t,cursor:i,log:r}=n,s=t.flatMap(c=>c.allowed!=null&&c.allowed>0?[c.allowed]:[]),[o,a]=i.window??i.whole,l=t.flatMap(({band:c})=>c?[...Array.from(c.low),...Array.from(c.high)]:[]);return{width:e,height:n.height??260,legend:{show:!1},scales:{x:{time:!1,auto:!1,min:o,max:a},y:r?{distr:3,range:(c,h,f)=>uT(c,Math.min(h??1,...s),Math.max(f??1,...s))}:{range:(c,h,f)=>h==null?ux(h,f):ux(Math.min(h,...l),Math.max(f,...l))}},series:[{},...t.map(c=>({stroke:()=>jn(Ti(c.style).color),width:c.faint?1:2,dash:Ti(c.style).dash,points:{show:!1}}))],axes:cT(n),cursor:{y:!1,points:{size:7},drag:{dist:6,x:!0,y:!1}},hooks:{setScale:[(c,h)=>{let{min:f,max:d}=c.scales.x;h==="x"&&f!=null&&d!=null&&(i.window=[f,d])}],drawAxes:[c=>ax(c,t)],draw:[c=>lx(c,t,h=>`allowed ${n.number(h)}`)]}}}function ip(n,e){let[t,i]=e.window??e.whole;i>t&&(n.scales.x.min!==t||n.scales.x.max!==i)&&n.setScale("x",{min:t,max:i}),n.setCursor({left:n.valToPos(e.time,"x"),top:0},!1)}function mT(n,e){let t=i=>n.posToVal(i.clientX-n.over.getBoundingClientRect().left,"x");n.over.addEventListener("mousemove",i=>e.hover(t(i))),n.over.addEventListener("mouseleave",()=>{e.hover(null),queueMicrotask(()=>ip(n,e))}),n.over.addEventListener("click",i=>e.pin=t(i)),n.over.addEventListener("dblclick",()=>e.window=null)}function As(n){let e=Ht(null),{curves:t,cursor:i,log:r,axis:s,height:o}=n;return Rt(()=>{let a=e.current,l=I0(t,r?P0(t):null),c=new Cn(pT(n,Math.max(200,a.clientWidth)),l,a);mT(c,i);let h=()=>{let m=Math.max(200,a.clientWidth);m!==c.width&&c.setSize({width:m,height:c.height})},f=()=>c.setSize({width:hT,height:c.height}),d=new ResizeObserver(h);d.observe(a),addEventListener("beforeprint",f),addEventListener("afterprint",h);let p=[i.listen(()=>ip(c,i)),Fo(()=>c.redraw(!1))];return queueMicrotask(()=>ip(c,i)),()=>{d.disconnect(),removeEventListener("beforeprint",f),removeEventListener("afterprint",h);for(let m of p)m();c.destroy()}},[t,i,r,s,o]),u("div",{class:"plot",ref:e,role:"img","aria-label":n.label})}function gT(n,e){let t=Pr(n.time,e);return t<0?"no samples":`${ge(n.value[t])} at ${ge(n.time[t],5)} s`}function _T(n,e){let t=Sc(n);if(!t)return n.value.length===0?"no samples":"nothing finite";let i=[];return e&&t.zeros>0&&i.push(`${Pt(t.zeros,"sample")} exactly 0, drawn on the lower edge`),t.lost>0&&i.push(`${Pt(t.lost,"sample")} not finite (or above 3.4e38), the first at ${ge(t.lostAt)} s`),i.join("; ")}function xT({curve:n,cursor:e,log:t,violations:i}){let r=bc(e),s=Ue(()=>Sc(n),[n]),o=n.violation;return u("tr",{children:[u("th",{scope:"row",children:[u(Rr,{style:n.style,faint:n.faint??!1})," ",J(n.label)]}),u("td",{class:"number at-cursor",children:gT(n,r)}),u("td",{class:"number",children:s?`${ge(s.least)} at ${ge(s.leastAt)} s`:""}),u("td",{class:"number",children:s?`${ge(s.greatest)} at ${ge(s.greatestAt)} s`:""}),i?u("td",{class:"number",children:o?`${ge(o.value)} at ${ge(o.time)} s`:""}):null,u("td",{children:_T(n,t)})]})}function Es({curves:n,cursor:e,log:t,unit:i,caption:r}){let s=n.some(a=>a.violation),o=[`curve${i?` [${i}]`:""}`,"at the cursor","least","greatest"];return o.push(...s?["first violation","remarks"]:["remarks"]),u("div",{class:"scroll curves",tabIndex:0,role:"region","aria-label":r,children:u("table",{children:[u("thead",{children:u("tr",{children:o.map(a=>u("th",{scope:"col",children:a},a))})}),u("tbody",{children:n.map((a,l)=>u(xT,{curve:a,cursor:e,log:t,violations:s},l))})]})})}function Cs(n,e,t){let i=e.map(r=>{let s=Sc(r),o=s?`greatest ${ge(s.greatest)} ${t} at ${ge(s.greatestAt)} s`:"nothing finite",a=r.violation?`, first beyond its tolerance at ${ge(r.violation.time)} s`:"";return`${J(r.label)}: ${o}${a}`});return`${n}. ${i.join(". ")}.`}function hx(n,e,t,i,r){let s=t&&e.allowed?e.allowed:1,o=n.floats(e.value),a=e.first_violation;return{label:i,style:r,time:n.floats(e.time),value:s===1?o:o.map(l=>l/s),allowed:t?1:e.allowed,violation:a?{time:a.time,value:a.value===null?null:a.value/s}:null}}function yT(n,e,t,i){let r=new Map,s=(o,a)=>{let l=i?"":o,c=r.get(l)??{unit:l,curves:[]};c.curves.push(a),r.set(l,c)};for(let{curve:o,index:a}of n){if(!o||i&&!o.allowed)continue;s(o.unit,hx(e,o,i,o.claim,a));let l=t?.block.trace.errors.find(c=>c.claim===o.claim);t&&l&&s(l.unit,{...hx(t.block,l,i,`${t.engine}: ${l.claim}`,a),faint:!0})}return[...r.values()]}function dx({rows:n,block:e,other:t,cursor:i}){let[r,s]=et(null),o=new Set(n.flatMap(h=>h.curve?[h.curve.unit]:[])),a=r??o.size>1,l=Ue(()=>yT(n,e,t,a),[n,e,t,a]),c=n.filter(h=>!h.curve?.allowed).length;return u("section",{"aria-labelledby":"errors-heading",children:[u("h3",{id:"errors-heading",children:"Errors against time"}),u("fieldset",{class:"choice on-screen",children:[u("legend",{class:"unseen",children:"Scale of the errors"}),u("label",{children:[u("input",{type:"radio",name:"error-scale",checked:!a,onChange:()=>s(!1)})," in their units"]}),u("label",{children:[u("input",{type:"radio",name:"error-scale",checked:a,onChange:()=>s(!0)})," over what is allowed"]})]}),l.length===0?u("p",{class:"empty",children:"No claim is chosen: tick claims in the table above."}):null,a&&c>0?u("p",{class:"note",children:[c," of the chosen claims allow nothing and are left out."]}):null,l.map(({unit:h,curves:f})=>{let d=a?"error / allowed":`error [${h||"1"}]`;return u("figure",{children:[u(As,{curves:f,label:Cs("Errors against time",f,a?"times what is allowed":h),axis:d,log:!0,cursor:i,number:ge}),u("figcaption",{children:u(Es,{curves:f,cursor:i,log:!0,unit:a?"of allowed":h,caption:d})})]},h)}),u("p",{class:"note",children:"Dashed levels: what is allowed. Ringed crosses: the first violation. Drag to look closer, double-click for all."})]})}var fx=12;function Zi(n){let[e,t]=et(!1);Rt(()=>{let r=()=>t(!0);return addEventListener("beforeprint",r),()=>removeEventListener("beforeprint",r)},[]);let i=n.length>fx&&!e?u("button",{type:"button",onClick:()=>t(!0),children:["show all ",n.length]}):null;return{list:e?n:n.slice(0,fx),button:i}}function px({events:n,cursor:e}){let{list:t,button:i}=Zi(n);return u("section",{"aria-labelledby":"events-heading",children:[u("h3",{id:"events-heading",children:"Events"}),n.length===0?u("p",{class:"empty",children:"None was recorded."}):null,n.length>0?u("table",{children:[u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"time"}),u("th",{scope:"col",children:"kind"}),u("th",{scope:"col",children:"what"})]})}),u("tbody",{children:t.map((r,s)=>u("tr",{children:[u("td",{class:"number",children:u("button",{type:"button",class:"plain-on-paper",onClick:()=>e.pin=r.time,title:"move the cursor here",children:[ge(r.time,8)," s"]})}),u("td",{children:J(r.kind)}),u("td",{children:J(r.what)})]},s))})]}):null,i]})}var je=(n,e)=>[n[0]+e[0],n[1]+e[1],n[2]+e[2]],mt=(n,e)=>[n[0]-e[0],n[1]-e[1],n[2]-e[2]],it=(n,e)=>[e*n[0],e*n[1],e*n[2]],xt=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2],Kr=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]],Tt=n=>Math.hypot(n[0],n[1],n[2]),ui=n=>{for(let e=0;e<n.length;++e)if(!Number.isFinite(n[e]))return!1;return!0};function mi(n,e){let t=Tt(n);return t>0&&Number.isFinite(t)?it(n,1/t):e}function jr(n){let[e,t,i]=[Math.abs(n[0]),Math.abs(n[1]),Math.abs(n[2])],r=e<=t&&e<=i?[1,0,0]:i<=t?[0,0,1]:[0,1,0],s=mi(Kr(n,r),[0,1,0]);return[Kr(s,n),s]}function Jt(n,e){let t=[n[1],n[2],n[3]];return je(e,it(Kr(t,je(Kr(t,e),it(e,n[0]))),2))}var Ki=n=>[n[0],-n[1],-n[2],-n[3]],Rs=(n,e)=>[n[0]*e[0]-n[1]*e[1]-n[2]*e[2]-n[3]*e[3],n[0]*e[1]+n[1]*e[0]+n[2]*e[3]-n[3]*e[2],n[0]*e[2]-n[1]*e[3]+n[2]*e[0]+n[3]*e[1],n[0]*e[3]+n[1]*e[2]-n[2]*e[1]+n[3]*e[0]];function vT(n){let e=[0,1,2].map(i=>n.slice(3*i,3*i+3)),t=[1,0,0,0];for(let i=0;i<12;++i)for(let[r,s]of[[0,1],[0,2],[1,2]]){let o=(e[r][s]+e[s][r])/2;if(!(Math.abs(o)>1e-15*(Math.abs(e[r][r])+Math.abs(e[s][s]))))continue;let a=Math.atan2(2*o,e[r][r]-e[s][s])/2,[l,c]=[Math.cos(a),Math.sin(a)];for(let d=0;d<3;++d)[e[d][r],e[d][s]]=[l*e[d][r]+c*e[d][s],l*e[d][s]-c*e[d][r]];for(let d=0;d<3;++d)[e[r][d],e[s][d]]=[l*e[r][d]+c*e[s][d],l*e[s][d]-c*e[r][d]];let h=3-r-s,f=[Math.cos(a/2),0,0,0];f[1+h]=Math.sin(a/2)*(h===1?-1:1),t=Rs(t,f)}return{moments:[e[0][0],e[1][1],e[2][2]],turn:t}}var bT=.04;function Zo(n){if(n.shape)return n.shape;let{moments:e,turn:t}=vT(n.inertia),[i,r,s]=e,o=Math.max(i,r,s);if(!(n.mass>0)||!(o>0)||!Number.isFinite(o/n.mass)||o-Math.min(i,r,s)<=1e-9*o)return null;let a=[r+s-i,s+i-r,i+r-s].map(h=>Math.sqrt(Math.max(0,1.5*h/n.mass))),l=bT*Math.max(...a),c={type:"box",half_extents:a.map(h=>Math.max(h,l))};return t[0]===1?c:{type:"compound",parts:[{shape:c,mass:n.mass,position:[0,0,0],orientation:t}]}}var ST=(n,e)=>n.reduce((t,i)=>Math.max(t,xt(i,e)),-1/0);function mx(n,e){if(!n)return 0;let t=Math.hypot(e[0],e[2]);switch(n.type){case"sphere":return n.radius;case"box":return n.half_extents.reduce((i,r,s)=>i+r*Math.abs(e[s]),0);case"capsule":return n.radius+n.length/2*Math.abs(e[1]);case"cylinder":return n.radius*t+n.length/2*Math.abs(e[1]);case"cone":return Math.max(.75*n.length*e[1],n.radius*t-.25*n.length*e[1]);case"rod":return n.length/2*Math.abs(e[1]);case"disc":return n.radius*t;case"hull":case"mesh":return ST(n.vertices,e);case"compound":return Math.max(...n.parts.map(i=>xt(i.position,e)+mx(i.shape,Jt(Ki(i.orientation),e))))}}function gx(n,e,t){let i=r=>{let s=[0,0,0];return s[t]=r,mx(n,Jt(Ki(e),s))};return{down:i(-1),up:i(1)}}function zc(n){if(!n)return 0;switch(n.type){case"sphere":case"disc":return n.radius;case"box":return Tt(n.half_extents);case"capsule":return n.radius+n.length/2;case"cylinder":return Math.hypot(n.radius,n.length/2);case"cone":return Math.max(.75*n.length,Math.hypot(n.radius,n.length/4));case"rod":return n.length/2;case"hull":case"mesh":return n.vertices.reduce((e,t)=>Math.max(e,Tt(t)),0);case"compound":return n.parts.reduce((e,t)=>Math.max(e,Tt(t.position)+zc(t.shape)),0)}}function rp(n,e,t){if(!(!ui(e)||!Number.isFinite(t)))for(let i=0;i<3;++i)n.min[i]=Math.min(n.min[i],e[i]-t),n.max[i]=Math.max(n.max[i],e[i]+t)}var MT=()=>({min:[1/0,1/0,1/0],max:[-1/0,-1/0,-1/0]});function Vc(n){if(!ui(n.min)||!ui(n.max))return{min:[-1,-1,-1],max:[1,1,1]};let e=Tt(mt(n.max,n.min)),t=e>0?.04*e:.5,i={min:[...n.min],max:[...n.max]};for(let r=0;r<3;++r){let s=t-(i.max[r]-i.min[r]);s>0&&(i.min[r]-=s/2,i.max[r]+=s/2)}return i}function wT(n,e,t){if(!ui(t.min)||!ui(t.max)||!ui(e.orientation))return;let i=Zo(e),r=zc(i),s=t.max.map((a,l)=>a-t.min[l]),o=Math.max(...s);for(let a=0;a<3;++a){let l=e.locked||o>r&&s[a]<.02*o,{down:c,up:h}=l?gx(i,e.orientation,a):{down:r,up:r};Number.isFinite(c+h)&&(n.min[a]=Math.min(n.min[a],t.min[a]-c),n.max[a]=Math.max(n.max[a],t.max[a]+h))}}function Ko(n,e){let t=MT();for(let o of n.body){let a={min:o.position,max:o.position};wT(t,o,o.locked?a:e??a)}for(let o of n.spring)o.pin&&rp(t,o.pin,0);for(let o of n.joint)o.point&&rp(t,o.point,0);if(!ui(t.min))return Vc(t);let i=it(je(t.min,t.max),.5),r=Math.max(Tt(mt(t.max,t.min)),.001),s=o=>{Tt(mt(o,i))<6*r&&rp(t,o,0)};for(let o of n.plane)s(je(i,it(o.normal,o.offset-xt(o.normal,i))));for(let o of n.water)s([i[0],o.level,i[2]]);return Vc(t)}function Hc(n){if(!(n>0)||!Number.isFinite(n))return 1;let e=10**Math.floor(Math.log10(n)),t=n/e;return(t>=5?5:t>=2?2:1)*e}var _x=["#0072b2","#e69f00","#009e73","#cc79a7","#56b4e9","#d55e00","#c9b800","#8a8a8a"];function ji(n){let e=/^#([0-9a-f]{2})([0-9a-f]{2})([0-9a-f]{2})$/i.exec(n);return e?e.slice(1).map(t=>parseInt(t,16)/255):null}function yx(n,e){let t=ji(n.color)??ji(_x[e%_x.length]);return n.locked?t.map(i=>.62*i):t}var TT={velocity:ji("#0b5cad"),momentum:ji("#0a7d4f"),"angular momentum":ji("#8b3fa8"),impulse:ji("#c2410c"),normal:ji("#666666")},AT={velocity:ji("#6db6ff"),momentum:ji("#4ade9c"),"angular momentum":ji("#d79bf0"),impulse:ji("#ff9d5c"),normal:ji("#b0b0b0")},Lr=(n,e,t)=>[n[0]+t*(e[0]-n[0]),n[1]+t*(e[1]-n[1]),n[2]+t*(e[2]-n[2])],Ri=n=>`rgb(${n.map(e=>Math.round(255*e)).join(" ")})`;function xx(n,e){let t=n&&document.createElement("canvas").getContext("2d");if(!t)return e;t.canvas.width=t.canvas.height=1,t.fillStyle="#010203",t.fillStyle=n,t.fillRect(0,0,1,1);let[i,r,s]=t.getImageData(0,0,1,1).data;return i===1&&r===2&&s===3?e:[i/255,r/255,s/255]}function sp(n){let e=getComputedStyle(n),t=matchMedia("(prefers-color-scheme: dark)").matches,i=xx(e.getPropertyValue("--ground").trim(),t?[.07,.08,.1]:[1,1,1]),r=xx(e.getPropertyValue("--ink").trim(),t?[.92,.93,.95]:[.1,.1,.12]),s=o=>.3*o[0]+.6*o[1]+.1*o[2];return{ground:i,ink:r,faint:Lr(i,r,.22),arrows:s(i)<.5?AT:TT}}var rl=40*Math.PI/180,vx=Math.PI/2-.001;function bx(n){return{target:[...n.target],distance:Math.min(Math.max(n.distance,1e-6),1e15),azimuth:n.azimuth%(2*Math.PI),elevation:Math.min(Math.max(n.elevation,-vx),vx)}}function Gc(n){let{azimuth:e,elevation:t}=n,i=[Math.cos(t)*Math.sin(e),Math.sin(t),Math.cos(t)*Math.cos(e)],r=[Math.cos(e),0,-Math.sin(e)];return[r,Kr(i,r),i]}function Sx(n,e,t){let[i,r,s]=Gc(n),{target:o,distance:a}=n,l=5*a+20*t,c=Math.max(.01*a,1e-5*l);return{eye:je(o,it(s,a)),right:i,up:r,back:s,target:o,distance:a,near:c,far:l,...e}}var fr=n=>2*n.distance*Math.tan(rl/2)/n.height;function Mx(n,e,t){let i=Math.tan(rl/2)/(n.height/2),r=je(it(n.right,(e-n.width/2)*i),it(n.up,(n.height/2-t)*i));return{from:n.eye,along:mt(r,n.back)}}function wx(n,e,t){let i=fr(n),r=je(it(n.right,(e-n.width/2)*i),it(n.up,(n.height/2-t)*i));return{from:je(n.eye,r),along:it(n.back,-1)}}function Pi(n,e){let t=mt(e,n.target),i=1/fr(n);return{x:n.width/2+i*xt(t,n.right),y:n.height/2-i*xt(t,n.up),depth:n.distance-xt(t,n.back)}}function op(n,e){let t=it(je(n.min,n.max),.5),i=it(mt(n.max,n.min),.5),r=i[2]<.4*Math.max(i[0],i[1]),s={target:t,distance:1,azimuth:r?.25:.55,elevation:r?.16:.3},[o,a,l]=Gc(s),c=Math.tan(rl/2),h=c*e,f=0;for(let d=0;d<8;++d){let p=[d&1?i[0]:-i[0],d&2?i[1]:-i[1],d&4?i[2]:-i[2]],m=Math.max(Math.abs(xt(p,o))/h,Math.abs(xt(p,a))/c);f=Math.max(f,m+xt(p,l))}return s.distance=f>0?1.06*f:5,s}var Tx=.008,Wc=Math.PI/36;function sl(n,e,t){return{...n,azimuth:n.azimuth-e,elevation:n.elevation+t}}function jo(n,e,t){let[i,r]=Gc(n);return{...n,target:je(n.target,je(it(i,e),it(r,t)))}}var ol=(n,e)=>({...n,distance:n.distance*e}),$c=class{constructor(e,t){this.element=e;this.scene=t;let i={signal:this.stop.signal};e.addEventListener("pointerdown",this.down,i),e.addEventListener("pointermove",this.move,i),e.addEventListener("pointerup",this.up,i),e.addEventListener("pointercancel",this.up,i),e.addEventListener("wheel",this.wheel,{...i,passive:!1}),e.addEventListener("keydown",this.key,i),e.addEventListener("contextmenu",r=>r.preventDefault(),i)}element;scene;pointers=new Map;holds=!1;stop=new AbortController;down=e=>{this.element.focus({preventScroll:!0}),this.element.setPointerCapture(e.pointerId),this.pointers.set(e.pointerId,{x:e.offsetX,y:e.offsetY}),this.pointers.size>1?this.letGo():e.button===0&&!e.shiftKey&&(this.holds=this.scene.grab(e.offsetX,e.offsetY))};move=e=>{let t=this.pointers.get(e.pointerId);if(!t)return;let[i,r]=[e.offsetX,e.offsetY],[s,o]=[i-t.x,r-t.y];if(this.holds)this.scene.pull(i,r);else if(this.pointers.size===1){let a=this.scene.camera,l=this.scene.metresPerPixel(),c=e.shiftKey||(e.buttons&6)!==0;this.scene.moveCamera(c?jo(a,-s*l,o*l):sl(a,s*Tx,o*Tx))}else this.pointers.size===2&&this.pinch(e.pointerId,t,{x:i,y:r});this.pointers.set(e.pointerId,{x:i,y:r})};pinch(e,t,i){for(let[r,s]of this.pointers){if(r===e)continue;let o=Math.hypot(t.x-s.x,t.y-s.y),a=Math.hypot(i.x-s.x,i.y-s.y),l=this.scene.metresPerPixel()/2,c=o>4&&a>4?ol(this.scene.camera,o/a):this.scene.camera;this.scene.moveCamera(jo(c,-(i.x-t.x)*l,(i.y-t.y)*l))}}up=e=>{this.pointers.delete(e.pointerId),this.letGo()};letGo(){this.holds&&this.scene.release(),this.holds=!1}wheel=e=>{e.preventDefault();let t=e.deltaMode===WheelEvent.DOM_DELTA_LINE?16:e.deltaMode===WheelEvent.DOM_DELTA_PAGE?300:1,i=Math.exp(Math.max(-120,Math.min(120,e.deltaY*t))*.0015);this.scene.moveCamera(ol(this.scene.camera,i))};key=e=>{if(e.ctrlKey||e.metaKey||e.altKey)return;let t=this.scene.camera,i=e.shiftKey?30*this.scene.metresPerPixel():0,s={ArrowLeft:()=>i?jo(t,-i,0):sl(t,Wc,0),ArrowRight:()=>i?jo(t,i,0):sl(t,-Wc,0),ArrowUp:()=>i?jo(t,0,i):sl(t,0,Wc),ArrowDown:()=>i?jo(t,0,-i):sl(t,0,-Wc),"+":()=>ol(t,1/1.15),"=":()=>ol(t,1/1.15),"-":()=>ol(t,1.15)}[e.key];if(s)this.scene.moveCamera(s());else if(e.key==="Home"||e.key==="0")this.scene.reset();else return;e.preventDefault(),e.stopPropagation()};dispose(){this.letGo(),this.stop.abort()}};var ap=[[1e9,"Gm"],[1e6,"Mm"],[1e3,"km"],[1,"m"],[.01,"cm"],[.001,"mm"],[1e-6,"\xB5m"],[1e-9,"nm"]];function lp(n){let[e,t]=ap.find(([i])=>n>=.9999*i)??ap[ap.length-1];return`${Number((n/e).toPrecision(3))} ${t}`}var cp=80;function Ax(n,e,t,i){let{width:r,height:s,ratio:o}=e;n.setTransform(o,0,0,o,0,o*(cp-s)),n.clearRect(0,0,r,s),n.font="11px system-ui, sans-serif",n.textBaseline="middle";let a=Ri(Lr(t.ink,t.ground,.15));ET(n,e,a,Ri(t.ground)),CT(n,e,a,Ri(t.ground),i)}function Ex(n,e,t,i,r,s){n.lineWidth=3,n.lineJoin="round",n.strokeStyle=s,n.strokeText(e,t,i),n.fillStyle=r,n.fillText(e,t,i)}function ET(n,{right:e,up:t,height:i},r,s){let[o,a,l]=[34,i-34,22],c=[[1,0,0],[0,1,0],[0,0,1]];n.textAlign="center",c.forEach((h,f)=>{let[d,p]=[e[f]*l,-t[f]*l];n.strokeStyle=r,n.lineWidth=1.5,n.beginPath(),n.moveTo(o,a),n.lineTo(o+d,a+p),n.stroke(),Ex(n,"xyz"[f],o+1.35*d,a+1.35*p,r,s)})}function CT(n,e,t,i,r){let s=fr(e),o=Hc(Math.min(120,e.width/4)*s),[a,l]=[e.width-14,e.height-14],c=a-o/s;n.strokeStyle=t,n.lineWidth=1.5,n.beginPath(),n.moveTo(c,l-4),n.lineTo(c,l),n.lineTo(a,l),n.lineTo(a,l-4),n.stroke(),n.textAlign="right",Ex(n,r===null?lp(o):`${lp(o)} \xB7 grid ${lp(r)}`,a,l-11,t,i)}function RT({from:n,along:e},t){let i=xt(e,e),r=xt(n,e),s=r*r-i*(xt(n,n)-t*t);if(!(s>=0))return null;let o=(-r-Math.sqrt(s))/i;return o>=0?o:null}function PT({from:n,along:e},t){let i=0,r=1/0;for(let s=0;s<3;++s){if(e[s]===0){if(Math.abs(n[s])>t[s])return null;continue}let o=(-Math.sign(e[s])*t[s]-n[s])/e[s],a=(Math.sign(e[s])*t[s]-n[s])/e[s];i=Math.max(i,o),r=Math.min(r,a)}return i<=r&&r>0?i:null}function Cx(n,e,t,i){let r=null;for(let s of e.pieces){let{body:o}=s;if(t.hidden[o])continue;let a=t.turn(o),l=je(t.at(o),Jt(a,s.position)),c=Ki(Rs(a,s.orientation)),h={from:Jt(c,mt(n.from,l)),along:Jt(c,n.along)},f=-xt(h.from,h.along)/Math.hypot(...n.along),d=i(Math.max(f,0)),p=s.mold==="sphere"||Math.max(...s.half)<d?RT(h,Math.max(s.half[0],d)):PT(h,s.half.map(m=>Math.max(m,d)));p!==null&&(!r||p<r.s)&&(r={body:o,s:p})}return r&&{body:r.body,point:je(n.from,it(n.along,r.s))}}var Rx=.1;function al(n,e){let t=n*e,i=t+3,r={along:new Float64Array(i),first:new Float64Array(i),second:new Float64Array(i)};r.along[i-1]=1;for(let s=0;s<=t;++s){let o=2*Math.PI*s/e;r.along[s+1]=Rx+(1-2*Rx)*(s/t),r.first[s+1]=Math.cos(o),r.second[s+1]=Math.sin(o)}return r}function Xc(n,e,t,i,r,s,o){let a=[i[0]-t[0],i[1]-t[1],i[2]-t[2]],l=Math.hypot(a[0],a[1],a[2]),[c,h]=jr(l>0?[a[0]/l,a[1]/l,a[2]/l]:[0,1,0]),[f,d,p]=t;for(let m=1;m<e.along.length;++m){let x=e.along[m],_=r*e.first[m],g=r*e.second[m],v=t[0]+x*a[0]+_*c[0]+g*h[0],E=t[1]+x*a[1]+_*c[1]+g*h[1],M=t[2]+x*a[2]+_*c[2]+g*h[2];n.put(f,d,p,v,E,M,s,o),[f,d,p]=[v,E,M]}}var Jc=class{constructor(e,t){this.extent=t;let i=new Map(e.body.map((o,a)=>[o.name,a])),r=o=>o===void 0?-1:i.get(o)??-1,s=(o,a)=>{let l=e.body[o];return l?{body:o,point:Jt(Ki(l.orientation),mt(a,l.position))}:{body:-1,point:a}};this.springs=e.spring.map(o=>{let a={body:r(o.body),point:o.anchor},l=o.to===void 0?{body:-1,point:o.pin??[0,0,0]}:{body:r(o.to),point:o.to_anchor??[0,0,0]};return{from:a,to:l,radius:Math.min(.012*t,o.rest_length>0?.15*o.rest_length:1/0)}}),this.joints=e.joint.map(o=>{let a=r(o.body),l=e.body[a]&&o.axis?Jt(Ki(e.body[a].orientation),mi(o.axis,[0,0,1])):[0,0,1];if(o.type==="distance"){let h=o.to===void 0?{body:-1,point:o.point??[0,0,0]}:{body:r(o.to),point:[0,0,0]};return{type:o.type,from:{body:a,point:[0,0,0]},to:h,axis:l}}let c=o.point??[0,0,0];return{type:o.type,from:s(a,c),to:s(r(o.to),c),axis:l}}),this.coil=this.springs.length<=200?al(8,10):al(4,4)}extent;springs;joints;coil;draw(e,t){let{ink:i,ground:r}=e.theme;for(let{from:s,to:o,radius:a}of this.springs)qc(t,s)||qc(t,o)||Xc(e.links,this.coil,Yc(t,s),Yc(t,o),a,Lr(i,r,.2),1.5);for(let s of this.joints)!qc(t,s.from)&&!qc(t,s.to)&&this.joint(e,t,s)}joint(e,t,{type:i,from:r,to:s,axis:o}){let{ink:a,ground:l}=e.theme,c=Lr(a,l,.35),[h,f]=[Yc(t,r),Yc(t,s)];if(i==="distance"){e.links.add(h,f,c,3),e.marks.dot(h,a,6),e.marks.dot(f,a,6);return}for(let[d,p]of[[r,h],[s,f]])d.body>=0&&Tt(d.point)>1e-9*this.extent&&e.links.add(t.at(d.body),p,c,1.5);if(e.marks.add(h,f,a,1,1,1),i==="fixed"){this.square(e,t,r,h);return}if(i==="hinge"){let d=it(r.body>=0?Jt(t.turn(r.body),o):o,.06*this.extent);e.marks.add(mt(h,d),je(h,d),a,3)}for(let d of[h,f])e.marks.dot(d,a,10),e.marks.dot(d,l,5)}square({marks:e,theme:t},i,r,s){let o=.018*this.extent,a=r.body>=0?Jt(i.turn(r.body),[0,0,1]):[0,0,1],[l,c]=jr(mi(a,[0,0,1])),h=f=>je(s,je(it(l,f&1?o:-o),it(c,f&2?o:-o)));for(let[f,d]of[[0,1],[1,3],[3,2],[2,0],[0,3],[1,2]])e.add(h(f),h(d),t.ink,2)}},qc=(n,e)=>e.body>=0&&n.hidden[e.body]===1;function Yc(n,e){return e.body<0?e.point:je(n.at(e.body),Jt(n.turn(e.body),e.point))}var Qo=class{data=new Float32Array(12*256);count=0;version=0;clear(){this.count=0,++this.version}add(e,t,i,r,s=r,o=0){this.put(e[0],e[1],e[2],t[0],t[1],t[2],i,r,s,o)}dot(e,t,i){this.add(e,e,t,i,i,2)}put(e,t,i,r,s,o,a,l,c=l,h=0){if((this.count+1)*12>this.data.length){let p=new Float32Array(2*this.data.length);p.set(this.data),this.data=p}let f=this.count*12,d=this.data;d[f]=e,d[f+1]=t,d[f+2]=i,d[f+3]=r,d[f+4]=s,d[f+5]=o,d[f+6]=a[0],d[f+7]=a[1],d[f+8]=a[2],d[f+9]=l,d[f+10]=c,d[f+11]=h,++this.count}};var Px={velocity:{width:2.5,pattern:0,heads:1},momentum:{width:4,pattern:1,heads:1},"angular momentum":{width:2.5,pattern:0,heads:2},impulse:{width:3.5,pattern:0,heads:1},normal:{width:1.5,pattern:1,heads:1}},IT=al(6,10);function ll(n,e,t,i,r,s,o=1,a=0){let l=Tt(t);if(!(l>1e-6*s))return;let c=Math.min(.4/o,.035*s/l),h=d=>je(e,it(t,d)),f=(3*r+5)*Math.min(1,l/(.07*s)+.25);n.add(e,h(1-o*c),i,r,r,a);for(let d=0;d<o;++d)n.add(h(1-(d+1)*c),h(1-d*c),i,f,0)}function Ix(n,e){for(let{at:t,along:i,kind:r}of e){if(!ui(t)||!ui(i))continue;let{width:s,pattern:o,heads:a}=Px[r];ll(n.marks,t,i,n.theme.arrows[r],s,n.extent,a,o)}}var LT=120;function Lx(n,e,t){let{marks:i,theme:r,extent:s,typical:o}=n,a=Math.min(.016*s,.7*o),l=r.arrows.impulse;for(let{point:c,normal:h,impulse:f}of e){if(!ui(c)||!ui(h))continue;let d=mi(h,[0,1,0]);e.length<=LT?DT(i,c,d,a,l):i.dot(c,l,4),f===null?ll(i,c,it(d,3*a),r.arrows.normal,1.5,s,1,1):Number.isFinite(f)&&t>0&&ll(i,c,it(d,.2*s*f/t),l,Px.impulse.width,s)}}function DT(n,e,t,i,r){let[s,o]=jr(t),a=l=>je(e,je(it(s,i*Math.cos(l)),it(o,i*Math.sin(l))));for(let l=0;l<16;++l)n.add(a(Math.PI*l/8),a(Math.PI*(l+1)/8),r,1.5);for(let l of[.4,.8,1.2,1.6,2,2.4,2.8])n.add(a(l),a(-l),r,1)}function Dx(n,e){for(let{from:t,to:i}of e)!ui(t)||!ui(i)||(Xc(n.marks,IT,t,i,.008*n.extent,n.theme.arrows.impulse,1.5),n.marks.dot(t,n.theme.arrows.impulse,8),n.marks.dot(i,n.theme.arrows.impulse,8))}function NT(n,e,t){let i=it(je(t.min,t.max),.5),r=Tt(mt(t.max,t.min)),s=je(i,it(n,e-xt(n,i))),[o,a]=jr(n),l=[[-1,-1],[1,-1],[1,1],[-1,1]].map(([c,h])=>je(s,je(it(o,c*r),it(a,h*r))));for(let c=0;c<3;++c)for(let h of[1,-1]){let f=[0,0,0];f[c]=h,l=Nx(l,f,h>0?t.max[c]:-t.min[c])}return l}function Nx(n,e,t){return n.flatMap((i,r)=>{let s=n[(r+1)%n.length],[o,a]=[xt(i,e)-t,xt(s,e)-t],l=o*a<0?[je(i,it(mt(s,i),o/(o-a)))]:[];return o<=0?[i,...l]:l})}function FT(n,e,t){let i=[];return n.forEach((r,s)=>{let o=n[(s+1)%n.length],[a,l]=[xt(r,e)-t,xt(o,e)-t];a<=0!=l<=0&&i.push(je(r,it(mt(o,r),a/(a-l))))}),i.length>=2?[i[0],i[1]]:null}var hp=n=>Hc(n/8),Fx=(n,e)=>n.plane.map(t=>xt(t.normal,e)>=t.offset);function Ux(n,e,t,i,r){let s=Tt(mt(t.max,t.min)),o=.18*s,a={min:mt(t.min,[o,o,o]),max:je(t.max,[o,o,o])},l=Lr(i.ground,i.ink,.5);e.plane.forEach((c,h)=>{let f=mi(c.normal,[0,1,0]),d=e.plane.reduce((g,v)=>v===c?g:Nx(g,it(v.normal,-1),-v.offset),NT(f,c.offset,a));if(d.length<3)return;if(!r[h]){d.forEach((g,v)=>n.add(g,d[(v+1)%d.length],i.faint,1));return}let p=hp(s);for(let g of jr(f)){let v=d.map(M=>xt(M,g)),E=Math.floor(Math.max(...v)/p);for(let M=Math.ceil(Math.min(...v)/p);M<=E;++M){let I=FT(d,g,M*p);I&&n.add(I[0],I[1],i.faint,1)}}let m=.25*p;d.forEach((g,v)=>{let E=d[(v+1)%d.length];n.add(g,E,l,1);let M=mt(E,g),I=Math.floor(Tt(M)/(p/2)),C=je(it(f,-m),it(mi(M,[0,0,0]),-m));for(let b=1;b<=I;++b){let A=je(g,it(M,(b-.5)/I));n.add(A,je(A,C),l,1)}});let x=d.reduce((g,v)=>je(g,it(v,1/d.length)),[0,0,0]),_=je(x,it(mt(d[0],x),.8));ll(n,_,it(f,-.07*s),l,2,s)})}var uy=0,zp=1,hy=2;var Dl=1,dy=2,Ta=3,Hs=0,fi=1,nr=2,mo=0,Aa=1,Hp=2,Gp=3,Wp=4,fy=5;var go=100,py=101,my=102,gy=103,_y=104,xy=200,yy=201,vy=202,by=203,$p=204,Xp=205,Sy=206,My=207,wy=208,Ty=209,Ay=210,Ey=211,Cy=212,Ry=213,Py=214,Su=0,Mu=1,wu=2,ga=3,Tu=4,Au=5,Eu=6,Cu=7,qp=0,Iy=1,Ly=2,Br=0,Yp=1,Jp=2,Zp=3,Kp=4,jp=5,Qp=6,em=7;var tm=300,_o=301,Ea=302,ih=303,rh=304,Ru=1e3,Fr=1001,Pu=1002,Xn=1003,Dy=1004;var Nl=1005;var di=1006,sh=1007;var as=1008;var Bi=1009,nm=1010,im=1011,Ca=1012,oh=1013,_r=1014,Vi=1015,xr=1016,ah=1017,lh=1018,xo=1020,rm=35902,sm=35899,om=1021,am=1022,zi=1023,ss=1026,ls=1027,lm=1028,ch=1029,Gs=1030,uh=1031;var hh=1033,Fl=33776,Ul=33777,kl=33778,Ol=33779,dh=35840,fh=35841,ph=35842,mh=35843,gh=36196,_h=37492,xh=37496,yh=37488,vh=37489,Bl=37490,bh=37491,Sh=37808,Mh=37809,wh=37810,Th=37811,Ah=37812,Eh=37813,Ch=37814,Rh=37815,Ph=37816,Ih=37817,Lh=37818,Dh=37819,Nh=37820,Fh=37821,Uh=36492,kh=36494,Oh=36495,Bh=36283,Vh=36284,Vl=36285,zh=36286;var ml=2300,Iu=2301,vu=2302,Fp=2303,Up=2400,kp=2401,Op=2402;var Ny=3200;var cm=0,Fy=1,cs="",Di="srgb",lo="srgb-linear",gl="linear",kt="srgb";var bu=7680;var Uy=519,ky=512,Oy=513,By=514,um=515,Vy=516,zy=517,hm=518,dm=519,fm=35044,yo=35048;var zl="300 es",er=2e3,_l=2001;function UT(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function kT(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function xl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Hy(){let n=xl("canvas");return n.style.display="block",n}var kx={},_a=null;function yl(...n){let e="THREE."+n.shift();_a?_a("log",e,...n):console.log(e,...n)}function Gy(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ke(...n){n=Gy(n);let e="THREE."+n.shift();if(_a)_a("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function st(...n){n=Gy(n);let e="THREE."+n.shift();if(_a)_a("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function pl(...n){let e=n.join(" ");e in kx||(kx[e]=!0,Ke(...n))}function Wy(n,e,t){return new Promise(function(i,r){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:r();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}setTimeout(s,t)})}var $y={[Su]:Su,[wu]:Eu,[Tu]:Tu,[ga]:Au,[Mu]:Mu,[Eu]:wu,[Cu]:Cu,[Au]:ga},Ur=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}},ei=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var dp=Math.PI/180,Lu=180/Math.PI;function vo(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ei[n&255]+ei[n>>8&255]+ei[n>>16&255]+ei[n>>24&255]+"-"+ei[e&255]+ei[e>>8&255]+"-"+ei[e>>16&15|64]+ei[e>>24&255]+"-"+ei[t&63|128]+ei[t>>8&255]+"-"+ei[t>>16&255]+ei[t>>24&255]+ei[i&255]+ei[i>>8&255]+ei[i>>16&255]+ei[i>>24&255]).toLowerCase()}function dt(n,e,t){return Math.max(e,Math.min(t,n))}function OT(n,e){return(n%e+e)%e}function fp(n,e,t){return(1-t)*n+t*e}function Xy(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Hh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function qy(n,e){if(e.constructor===Float32Array)return n;let t=Hh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Yy(n,e){if(e.constructor===Float32Array)return n;let t=Hh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Et=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=dt(this.x,e.x,t.x),this.y=dt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=dt(this.x,e,t),this.y=dt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(dt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(dt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*i-o*r+e.x,this.y=s*r+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},kr=class{constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,s,o,a){let l=i[r+0],c=i[r+1],h=i[r+2],f=i[r+3],d=s[o+0],p=s[o+1],m=s[o+2],x=s[o+3];if(f!==x||l!==d||c!==p||h!==m){let _=l*d+c*p+h*m+f*x;_<0&&(d=-d,p=-p,m=-m,x=-x,_=-_);let g=1-a;if(_<.9995){let v=Math.acos(_),E=Math.sin(v);g=Math.sin(g*v)/E,a=Math.sin(a*v)/E,l=l*g+d*a,c=c*g+p*a,h=h*g+m*a,f=f*g+x*a}else{l=l*g+d*a,c=c*g+p*a,h=h*g+m*a,f=f*g+x*a;let v=1/Math.sqrt(l*l+c*c+h*h+f*f);l*=v,c*=v,h*=v,f*=v}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,r,s,o){let a=i[r],l=i[r+1],c=i[r+2],h=i[r+3],f=s[o],d=s[o+1],p=s[o+2],m=s[o+3];return e[t]=a*m+h*f+l*p-c*d,e[t+1]=l*m+h*d+c*f-a*p,e[t+2]=c*m+h*p+a*d-l*f,e[t+3]=h*m-a*f-l*d-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(r/2),f=a(s/2),d=l(i/2),p=l(r/2),m=l(s/2);switch(o){case"XYZ":this._x=d*h*f+c*p*m,this._y=c*p*f-d*h*m,this._z=c*h*m+d*p*f,this._w=c*h*f-d*p*m;break;case"YXZ":this._x=d*h*f+c*p*m,this._y=c*p*f-d*h*m,this._z=c*h*m-d*p*f,this._w=c*h*f+d*p*m;break;case"ZXY":this._x=d*h*f-c*p*m,this._y=c*p*f+d*h*m,this._z=c*h*m+d*p*f,this._w=c*h*f-d*p*m;break;case"ZYX":this._x=d*h*f-c*p*m,this._y=c*p*f+d*h*m,this._z=c*h*m-d*p*f,this._w=c*h*f+d*p*m;break;case"YZX":this._x=d*h*f+c*p*m,this._y=c*p*f+d*h*m,this._z=c*h*m-d*p*f,this._w=c*h*f-d*p*m;break;case"XZY":this._x=d*h*f-c*p*m,this._y=c*p*f-d*h*m,this._z=c*h*m+d*p*f,this._w=c*h*f+d*p*m;break;default:Ke("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],s=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],f=t[10],d=i+a+f;if(d>0){let p=.5/Math.sqrt(d+1);this._w=.25/p,this._x=(h-l)*p,this._y=(s-c)*p,this._z=(o-r)*p}else if(i>a&&i>f){let p=2*Math.sqrt(1+i-a-f);this._w=(h-l)/p,this._x=.25*p,this._y=(r+o)/p,this._z=(s+c)/p}else if(a>f){let p=2*Math.sqrt(1+a-i-f);this._w=(s-c)/p,this._x=(r+o)/p,this._y=.25*p,this._z=(l+h)/p}else{let p=2*Math.sqrt(1+f-i-a);this._w=(o-r)/p,this._x=(s+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(dt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=i*h+o*a+r*c-s*l,this._y=r*h+o*l+s*a-i*c,this._z=s*h+o*c+i*l-r*a,this._w=o*h-i*a-r*l-s*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,r=-r,s=-s,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Ox.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Ox.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*r,this.y=s[1]*t+s[4]*i+s[7]*r,this.z=s[2]*t+s[5]*i+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,s=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*r-a*i),h=2*(a*t-s*r),f=2*(s*i-o*t);return this.x=t+l*c+o*f-a*h,this.y=i+l*h+a*c-s*f,this.z=r+l*f+s*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*r,this.y=s[1]*t+s[5]*i+s[9]*r,this.z=s[2]*t+s[6]*i+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=dt(this.x,e.x,t.x),this.y=dt(this.y,e.y,t.y),this.z=dt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=dt(this.x,e,t),this.y=dt(this.y,e,t),this.z=dt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(dt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,s=e.z,o=t.x,a=t.y,l=t.z;return this.x=r*l-s*a,this.y=s*o-i*l,this.z=i*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return pp.copy(this).projectOnVector(e),this.sub(pp)}reflect(e){return this.sub(pp.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(dt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},pp=new X,Ox=new kr,ot=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c)}set(e,t,i,r,s,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=r,h[2]=a,h[3]=t,h[4]=s,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],f=i[7],d=i[2],p=i[5],m=i[8],x=r[0],_=r[3],g=r[6],v=r[1],E=r[4],M=r[7],I=r[2],C=r[5],b=r[8];return s[0]=o*x+a*v+l*I,s[3]=o*_+a*E+l*C,s[6]=o*g+a*M+l*b,s[1]=c*x+h*v+f*I,s[4]=c*_+h*E+f*C,s[7]=c*g+h*M+f*b,s[2]=d*x+p*v+m*I,s[5]=d*_+p*E+m*C,s[8]=d*g+p*M+m*b,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-i*s*h+i*a*l+r*s*c-r*o*l}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],f=h*o-a*c,d=a*l-h*s,p=c*s-o*l,m=t*f+i*d+r*p;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/m;return e[0]=f*x,e[1]=(r*c-h*i)*x,e[2]=(a*i-r*o)*x,e[3]=d*x,e[4]=(h*t-r*l)*x,e[5]=(r*s-a*t)*x,e[6]=p*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*s)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-r*c,r*l,-r*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return pl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(mp.makeScale(e,t)),this}rotate(e){return pl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(mp.makeRotation(-e)),this}translate(e,t){return pl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(mp.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},mp=new ot,Bx=new ot().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Vx=new ot().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function BT(){let n={enabled:!0,workingColorSpace:lo,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===kt&&(r.r=rs(r.r),r.g=rs(r.g),r.b=rs(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===kt&&(r.r=ma(r.r),r.g=ma(r.g),r.b=ma(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===cs?gl:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[lo]:{primaries:e,whitePoint:i,transfer:gl,toXYZ:Bx,fromXYZ:Vx,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Di},outputColorSpaceConfig:{drawingBufferColorSpace:Di}},[Di]:{primaries:e,whitePoint:i,transfer:kt,toXYZ:Bx,fromXYZ:Vx,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Di}}}),n}var bt=BT();function rs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ma(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var ea,Du=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{ea===void 0&&(ea=xl("canvas")),ea.width=e.width,ea.height=e.height;let r=ea.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=ea}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=xl("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=rs(s[o]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(rs(t[i]/255)*255):t[i]=rs(t[i]);return{data:t,width:e.width,height:e.height}}else return Ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},VT=0,xa=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:VT++}),this.uuid=vo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(gp(r[o].image)):s.push(gp(r[o]))}else s=gp(r);i.url=s}return t||(e.images[this.uuid]=i),i}};function gp(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Du.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ke("Texture: Unable to serialize Texture."),{})}var zT=0,_p=new X,_i=class n extends Ur{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Fr,r=Fr,s=di,o=as,a=zi,l=Bi,c=n.DEFAULT_ANISOTROPY,h=cs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:zT++}),this.uuid=vo(),this.name="",this.source=new xa(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Et(0,0),this.repeat=new Et(1,1),this.center=new Et(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ot,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(_p).x}get height(){return this.source.getSize(_p).y}get depth(){return this.source.getSize(_p).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Ke(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==tm)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ru:e.x=e.x-Math.floor(e.x);break;case Fr:e.x=e.x<0?0:1;break;case Pu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ru:e.y=e.y-Math.floor(e.y);break;case Fr:e.y=e.y<0?0:1;break;case Pu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};_i.DEFAULT_IMAGE=null;_i.DEFAULT_MAPPING=tm;_i.DEFAULT_ANISOTROPY=1;var ln=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*i+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,s,l=e.elements,c=l[0],h=l[4],f=l[8],d=l[1],p=l[5],m=l[9],x=l[2],_=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(f-x)<.01&&Math.abs(m-_)<.01){if(Math.abs(h+d)<.1&&Math.abs(f+x)<.1&&Math.abs(m+_)<.1&&Math.abs(c+p+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let E=(c+1)/2,M=(p+1)/2,I=(g+1)/2,C=(h+d)/4,b=(f+x)/4,A=(m+_)/4;return E>M&&E>I?E<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(E),r=C/i,s=b/i):M>I?M<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(M),i=C/r,s=A/r):I<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(I),i=b/s,r=A/s),this.set(i,r,s,t),this}let v=Math.sqrt((_-m)*(_-m)+(f-x)*(f-x)+(d-h)*(d-h));return Math.abs(v)<.001&&(v=1),this.x=(_-m)/v,this.y=(f-x)/v,this.z=(d-h)/v,this.w=Math.acos((c+p+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=dt(this.x,e.x,t.x),this.y=dt(this.y,e.y,t.y),this.z=dt(this.z,e.z,t.z),this.w=dt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=dt(this.x,e,t),this.y=dt(this.y,e,t),this.z=dt(this.z,e,t),this.w=dt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(dt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Nu=class extends Ur{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:di,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new ln(0,0,e,t),this.scissorTest=!1,this.viewport=new ln(0,0,e,t),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new _i({width:e,height:t,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:di,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new xa(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ui=class extends Nu{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},vl=class extends _i{constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Xn,this.minFilter=Xn,this.wrapR=Fr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Fu=class extends _i{constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Xn,this.minFilter=Xn,this.wrapR=Fr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Zt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,r,s,o,a,l,c,h,f,d,p,m,x,_){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c,h,f,d,p,m,x,_)}set(e,t,i,r,s,o,a,l,c,h,f,d,p,m,x,_){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=r,g[1]=s,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=f,g[14]=d,g[3]=p,g[7]=m,g[11]=x,g[15]=_,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,r=1/ta.setFromMatrixColumn(e,0).length(),s=1/ta.setFromMatrixColumn(e,1).length(),o=1/ta.setFromMatrixColumn(e,2).length();return t[0]=i[0]*r,t[1]=i[1]*r,t[2]=i[2]*r,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,r=e.y,s=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(r),c=Math.sin(r),h=Math.cos(s),f=Math.sin(s);if(e.order==="XYZ"){let d=o*h,p=o*f,m=a*h,x=a*f;t[0]=l*h,t[4]=-l*f,t[8]=c,t[1]=p+m*c,t[5]=d-x*c,t[9]=-a*l,t[2]=x-d*c,t[6]=m+p*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,p=l*f,m=c*h,x=c*f;t[0]=d+x*a,t[4]=m*a-p,t[8]=o*c,t[1]=o*f,t[5]=o*h,t[9]=-a,t[2]=p*a-m,t[6]=x+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,p=l*f,m=c*h,x=c*f;t[0]=d-x*a,t[4]=-o*f,t[8]=m+p*a,t[1]=p+m*a,t[5]=o*h,t[9]=x-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,p=o*f,m=a*h,x=a*f;t[0]=l*h,t[4]=m*c-p,t[8]=d*c+x,t[1]=l*f,t[5]=x*c+d,t[9]=p*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,p=o*c,m=a*l,x=a*c;t[0]=l*h,t[4]=x-d*f,t[8]=m*f+p,t[1]=f,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=p*f+m,t[10]=d-x*f}else if(e.order==="XZY"){let d=o*l,p=o*c,m=a*l,x=a*c;t[0]=l*h,t[4]=-f,t[8]=c*h,t[1]=d*f+x,t[5]=o*h,t[9]=p*f-m,t[2]=m*f-p,t[6]=a*h,t[10]=x*f+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(HT,e,GT)}lookAt(e,t,i){let r=this.elements;return Ii.subVectors(e,t),Ii.lengthSq()===0&&(Ii.z=1),Ii.normalize(),Ps.crossVectors(i,Ii),Ps.lengthSq()===0&&(Math.abs(i.z)===1?Ii.x+=1e-4:Ii.z+=1e-4,Ii.normalize(),Ps.crossVectors(i,Ii)),Ps.normalize(),Kc.crossVectors(Ii,Ps),r[0]=Ps.x,r[4]=Kc.x,r[8]=Ii.x,r[1]=Ps.y,r[5]=Kc.y,r[9]=Ii.y,r[2]=Ps.z,r[6]=Kc.z,r[10]=Ii.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],f=i[5],d=i[9],p=i[13],m=i[2],x=i[6],_=i[10],g=i[14],v=i[3],E=i[7],M=i[11],I=i[15],C=r[0],b=r[4],A=r[8],G=r[12],F=r[1],D=r[5],H=r[9],V=r[13],N=r[2],W=r[6],K=r[10],z=r[14],ue=r[3],j=r[7],ee=r[11],se=r[15];return s[0]=o*C+a*F+l*N+c*ue,s[4]=o*b+a*D+l*W+c*j,s[8]=o*A+a*H+l*K+c*ee,s[12]=o*G+a*V+l*z+c*se,s[1]=h*C+f*F+d*N+p*ue,s[5]=h*b+f*D+d*W+p*j,s[9]=h*A+f*H+d*K+p*ee,s[13]=h*G+f*V+d*z+p*se,s[2]=m*C+x*F+_*N+g*ue,s[6]=m*b+x*D+_*W+g*j,s[10]=m*A+x*H+_*K+g*ee,s[14]=m*G+x*V+_*z+g*se,s[3]=v*C+E*F+M*N+I*ue,s[7]=v*b+E*D+M*W+I*j,s[11]=v*A+E*H+M*K+I*ee,s[15]=v*G+E*V+M*z+I*se,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],f=e[6],d=e[10],p=e[14],m=e[3],x=e[7],_=e[11],g=e[15],v=l*p-c*d,E=a*p-c*f,M=a*d-l*f,I=o*p-c*h,C=o*d-l*h,b=o*f-a*h;return t*(x*v-_*E+g*M)-i*(m*v-_*I+g*C)+r*(m*E-x*I+g*b)-s*(m*M-x*C+_*b)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-i*(s*h-a*l)+r*(s*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],f=e[9],d=e[10],p=e[11],m=e[12],x=e[13],_=e[14],g=e[15],v=t*a-i*o,E=t*l-r*o,M=t*c-s*o,I=i*l-r*a,C=i*c-s*a,b=r*c-s*l,A=h*x-f*m,G=h*_-d*m,F=h*g-p*m,D=f*_-d*x,H=f*g-p*x,V=d*g-p*_,N=v*V-E*H+M*D+I*F-C*G+b*A;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return e[0]=(a*V-l*H+c*D)*W,e[1]=(r*H-i*V-s*D)*W,e[2]=(x*b-_*C+g*I)*W,e[3]=(d*C-f*b-p*I)*W,e[4]=(l*F-o*V-c*G)*W,e[5]=(t*V-r*F+s*G)*W,e[6]=(_*M-m*b-g*E)*W,e[7]=(h*b-d*M+p*E)*W,e[8]=(o*H-a*F+c*A)*W,e[9]=(i*F-t*H-s*A)*W,e[10]=(m*C-x*M+g*v)*W,e[11]=(f*M-h*C-p*v)*W,e[12]=(a*G-o*D-l*A)*W,e[13]=(t*D-i*G+r*A)*W,e[14]=(x*E-m*I-_*v)*W,e[15]=(h*I-f*E+d*v)*W,this}scale(e){let t=this.elements,i=e.x,r=e.y,s=e.z;return t[0]*=i,t[4]*=r,t[8]*=s,t[1]*=i,t[5]*=r,t[9]*=s,t[2]*=i,t[6]*=r,t[10]*=s,t[3]*=i,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,r))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),r=Math.sin(t),s=1-i,o=e.x,a=e.y,l=e.z,c=s*o,h=s*a;return this.set(c*o+i,c*a-r*l,c*l+r*a,0,c*a+r*l,h*a+i,h*l-r*o,0,c*l-r*a,h*l+r*o,s*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,r,s,o){return this.set(1,i,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,i){let r=this.elements,s=t._x,o=t._y,a=t._z,l=t._w,c=s+s,h=o+o,f=a+a,d=s*c,p=s*h,m=s*f,x=o*h,_=o*f,g=a*f,v=l*c,E=l*h,M=l*f,I=i.x,C=i.y,b=i.z;return r[0]=(1-(x+g))*I,r[1]=(p+M)*I,r[2]=(m-E)*I,r[3]=0,r[4]=(p-M)*C,r[5]=(1-(d+g))*C,r[6]=(_+v)*C,r[7]=0,r[8]=(m+E)*b,r[9]=(_-v)*b,r[10]=(1-(d+x))*b,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,i){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),t.identity(),this;let o=ta.set(r[0],r[1],r[2]).length(),a=ta.set(r[4],r[5],r[6]).length(),l=ta.set(r[8],r[9],r[10]).length();s<0&&(o=-o),pr.copy(this);let c=1/o,h=1/a,f=1/l;return pr.elements[0]*=c,pr.elements[1]*=c,pr.elements[2]*=c,pr.elements[4]*=h,pr.elements[5]*=h,pr.elements[6]*=h,pr.elements[8]*=f,pr.elements[9]*=f,pr.elements[10]*=f,t.setFromRotationMatrix(pr),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,r,s,o,a=er,l=!1){let c=this.elements,h=2*s/(t-e),f=2*s/(i-r),d=(t+e)/(t-e),p=(i+r)/(i-r),m,x;if(l)m=s/(o-s),x=o*s/(o-s);else if(a===er)m=-(o+s)/(o-s),x=-2*o*s/(o-s);else if(a===_l)m=-o/(o-s),x=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=f,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,r,s,o,a=er,l=!1){let c=this.elements,h=2/(t-e),f=2/(i-r),d=-(t+e)/(t-e),p=-(i+r)/(i-r),m,x;if(l)m=1/(o-s),x=o/(o-s);else if(a===er)m=-2/(o-s),x=-(o+s)/(o-s);else if(a===_l)m=-1/(o-s),x=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=f,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<16;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},ta=new X,pr=new Zt,HT=new X(0,0,0),GT=new X(1,1,1),Ps=new X,Kc=new X,Ii=new X,zx=new Zt,Hx=new kr,Fs=class n{constructor(e=0,t=0,i=0,r=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,r=this._order){return this._x=e,this._y=t,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],h=r[9],f=r[2],d=r[6],p=r[10];switch(t){case"XYZ":this._y=Math.asin(dt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-dt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,s),this._z=0);break;case"ZXY":this._x=Math.asin(dt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-f,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-dt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(d,p),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(dt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-f,s)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-dt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-h,p),this._y=0);break;default:Ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return zx.makeRotationFromQuaternion(e),this.setFromRotationMatrix(zx,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Hx.setFromEuler(this),this.setFromQuaternion(Hx,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Fs.DEFAULT_ORDER="XYZ";var bl=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},WT=0,Gx=new X,na=new kr,Qr=new Zt,jc=new X,cl=new X,$T=new X,XT=new kr,Wx=new X(1,0,0),$x=new X(0,1,0),Xx=new X(0,0,1),qx={type:"added"},qT={type:"removed"},ia={type:"childadded",child:null},xp={type:"childremoved",child:null},ki=class n extends Ur{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:WT++}),this.uuid=vo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new X,t=new Fs,i=new kr,r=new X(1,1,1);function s(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new Zt},normalMatrix:{value:new ot}}),this.matrix=new Zt,this.matrixWorld=new Zt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new bl,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return na.setFromAxisAngle(e,t),this.quaternion.multiply(na),this}rotateOnWorldAxis(e,t){return na.setFromAxisAngle(e,t),this.quaternion.premultiply(na),this}rotateX(e){return this.rotateOnAxis(Wx,e)}rotateY(e){return this.rotateOnAxis($x,e)}rotateZ(e){return this.rotateOnAxis(Xx,e)}translateOnAxis(e,t){return Gx.copy(e).applyQuaternion(this.quaternion),this.position.add(Gx.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Wx,e)}translateY(e){return this.translateOnAxis($x,e)}translateZ(e){return this.translateOnAxis(Xx,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Qr.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?jc.copy(e):jc.set(e,t,i);let r=this.parent;this.updateWorldMatrix(!0,!1),cl.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Qr.lookAt(cl,jc,this.up):Qr.lookAt(jc,cl,this.up),this.quaternion.setFromRotationMatrix(Qr),r&&(Qr.extractRotation(r.matrixWorld),na.setFromRotationMatrix(Qr),this.quaternion.premultiply(na.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(st("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(qx),ia.child=e,this.dispatchEvent(ia),ia.child=null):st("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(qT),xp.child=e,this.dispatchEvent(xp),xp.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Qr.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Qr.multiply(e.parent.matrixWorld)),e.applyMatrix4(Qr),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(qx),ia.child=e,this.dispatchEvent(ia),ia.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(cl,e,$T),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(cl,XT,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*r,s[13]+=i-s[1]*t-s[5]*i-s[9]*r,s[14]+=r-s[2]*t-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let f=l[c];s(e.shapes,f)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(e.materials,this.material[l]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),f=o(e.shapes),d=o(e.skeletons),p=o(e.animations),m=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),f.length>0&&(i.shapes=f),d.length>0&&(i.skeletons=d),p.length>0&&(i.animations=p),m.length>0&&(i.nodes=m)}return i.object=r,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let r=e.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ki.DEFAULT_UP=new X(0,1,0);ki.DEFAULT_MATRIX_AUTO_UPDATE=!0;ki.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ao=class extends ki{constructor(){super(),this.isGroup=!0,this.type="Group"}},YT={type:"move"},ya=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ao,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ao,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ao,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let _=t.getJointPose(x,i),g=this._getHandJoint(c,x);_!==null&&(g.matrix.fromArray(_.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=_.radius),g.visible=_!==null}let h=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],d=h.position.distanceTo(f.position),p=.02,m=.005;c.inputState.pinching&&d>p+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=p-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(YT)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new ao;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Jy={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Is={h:0,s:0,l:0},Qc={h:0,s:0,l:0};function yp(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var Ct=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Di){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,bt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=bt.workingColorSpace){return this.r=e,this.g=t,this.b=i,bt.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=bt.workingColorSpace){if(e=OT(e,1),t=dt(t,0,1),i=dt(i,0,1),t===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+t):i+t-i*t,o=2*i-s;this.r=yp(o,s,e+1/3),this.g=yp(o,s,e),this.b=yp(o,s,e-1/3)}return bt.colorSpaceToWorking(this,r),this}setStyle(e,t=Di){function i(s){s!==void 0&&parseFloat(s)<1&&Ke("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:Ke("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);Ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Di){let i=Jy[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=rs(e.r),this.g=rs(e.g),this.b=rs(e.b),this}copyLinearToSRGB(e){return this.r=ma(e.r),this.g=ma(e.g),this.b=ma(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Di){return bt.workingToColorSpace(ti.copy(this),e),Math.round(dt(ti.r*255,0,255))*65536+Math.round(dt(ti.g*255,0,255))*256+Math.round(dt(ti.b*255,0,255))}getHexString(e=Di){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=bt.workingColorSpace){bt.workingToColorSpace(ti.copy(this),t);let i=ti.r,r=ti.g,s=ti.b,o=Math.max(i,r,s),a=Math.min(i,r,s),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=h<=.5?f/(o+a):f/(2-o-a),o){case i:l=(r-s)/f+(r<s?6:0);break;case r:l=(s-i)/f+2;break;case s:l=(i-r)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=bt.workingColorSpace){return bt.workingToColorSpace(ti.copy(this),t),e.r=ti.r,e.g=ti.g,e.b=ti.b,e}getStyle(e=Di){bt.workingToColorSpace(ti.copy(this),e);let t=ti.r,i=ti.g,r=ti.b;return e!==Di?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(Is),this.setHSL(Is.h+e,Is.s+t,Is.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Is),e.getHSL(Qc);let i=fp(Is.h,Qc.h,t),r=fp(Is.s,Qc.s,t),s=fp(Is.l,Qc.l,t);return this.setHSL(i,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*r,this.g=s[1]*t+s[4]*i+s[7]*r,this.b=s[2]*t+s[5]*i+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ti=new Ct;Ct.NAMES=Jy;var Sl=class extends ki{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Fs,this.environmentIntensity=1,this.environmentRotation=new Fs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},mr=new X,es=new X,vp=new X,ts=new X,ra=new X,sa=new X,Yx=new X,bp=new X,Sp=new X,Mp=new X,wp=new ln,Tp=new ln,Ap=new ln,Nr=class n{constructor(e=new X,t=new X,i=new X){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,r){r.subVectors(i,t),mr.subVectors(e,t),r.cross(mr);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,i,r,s){mr.subVectors(r,t),es.subVectors(i,t),vp.subVectors(e,t);let o=mr.dot(mr),a=mr.dot(es),l=mr.dot(vp),c=es.dot(es),h=es.dot(vp),f=o*c-a*a;if(f===0)return s.set(0,0,0),null;let d=1/f,p=(c*l-a*h)*d,m=(o*h-a*l)*d;return s.set(1-p-m,m,p)}static containsPoint(e,t,i,r){return this.getBarycoord(e,t,i,r,ts)===null?!1:ts.x>=0&&ts.y>=0&&ts.x+ts.y<=1}static getInterpolation(e,t,i,r,s,o,a,l){return this.getBarycoord(e,t,i,r,ts)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,ts.x),l.addScaledVector(o,ts.y),l.addScaledVector(a,ts.z),l)}static getInterpolatedAttribute(e,t,i,r,s,o){return wp.setScalar(0),Tp.setScalar(0),Ap.setScalar(0),wp.fromBufferAttribute(e,t),Tp.fromBufferAttribute(e,i),Ap.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(wp,s.x),o.addScaledVector(Tp,s.y),o.addScaledVector(Ap,s.z),o}static isFrontFacing(e,t,i,r){return mr.subVectors(i,t),es.subVectors(e,t),mr.cross(es).dot(r)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,r){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,i,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return mr.subVectors(this.c,this.b),es.subVectors(this.a,this.b),mr.cross(es).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,r,s){return n.getInterpolation(e,this.a,this.b,this.c,t,i,r,s)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,r=this.b,s=this.c,o,a;ra.subVectors(r,i),sa.subVectors(s,i),bp.subVectors(e,i);let l=ra.dot(bp),c=sa.dot(bp);if(l<=0&&c<=0)return t.copy(i);Sp.subVectors(e,r);let h=ra.dot(Sp),f=sa.dot(Sp);if(h>=0&&f<=h)return t.copy(r);let d=l*f-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(i).addScaledVector(ra,o);Mp.subVectors(e,s);let p=ra.dot(Mp),m=sa.dot(Mp);if(m>=0&&p<=m)return t.copy(s);let x=p*c-l*m;if(x<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(i).addScaledVector(sa,a);let _=h*m-p*f;if(_<=0&&f-h>=0&&p-m>=0)return Yx.subVectors(s,r),a=(f-h)/(f-h+(p-m)),t.copy(r).addScaledVector(Yx,a);let g=1/(_+x+d);return o=x*g,a=d*g,t.copy(i).addScaledVector(ra,o).addScaledVector(sa,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Us=class{constructor(e=new X(1/0,1/0,1/0),t=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(gr.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(gr.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=gr.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,gr):gr.fromBufferAttribute(s,o),gr.applyMatrix4(e.matrixWorld),this.expandByPoint(gr);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),eu.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),eu.copy(i.boundingBox)),eu.applyMatrix4(e.matrixWorld),this.union(eu)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,gr),gr.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ul),tu.subVectors(this.max,ul),oa.subVectors(e.a,ul),aa.subVectors(e.b,ul),la.subVectors(e.c,ul),Ls.subVectors(aa,oa),Ds.subVectors(la,aa),io.subVectors(oa,la);let t=[0,-Ls.z,Ls.y,0,-Ds.z,Ds.y,0,-io.z,io.y,Ls.z,0,-Ls.x,Ds.z,0,-Ds.x,io.z,0,-io.x,-Ls.y,Ls.x,0,-Ds.y,Ds.x,0,-io.y,io.x,0];return!Ep(t,oa,aa,la,tu)||(t=[1,0,0,0,1,0,0,0,1],!Ep(t,oa,aa,la,tu))?!1:(nu.crossVectors(Ls,Ds),t=[nu.x,nu.y,nu.z],Ep(t,oa,aa,la,tu))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,gr).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(gr).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ns[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ns[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ns[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ns[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ns[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ns[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ns[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ns[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ns),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ns=[new X,new X,new X,new X,new X,new X,new X,new X],gr=new X,eu=new Us,oa=new X,aa=new X,la=new X,Ls=new X,Ds=new X,io=new X,ul=new X,tu=new X,nu=new X,ro=new X;function Ep(n,e,t,i,r){for(let s=0,o=n.length-3;s<=o;s+=3){ro.fromArray(n,s);let a=r.x*Math.abs(ro.x)+r.y*Math.abs(ro.y)+r.z*Math.abs(ro.z),l=e.dot(ro),c=t.dot(ro),h=i.dot(ro);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Rn=new X,iu=new Et,JT=0,pn=class extends Ur{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:JT++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=fm,this.updateRanges=[],this.gpuType=Vi,this.version=0,this._normalizationScale=e!==void 0?Hh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)iu.fromBufferAttribute(this,t),iu.applyMatrix3(e),this.setXY(t,iu.x,iu.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Rn.fromBufferAttribute(this,t),Rn.applyMatrix3(e),this.setXYZ(t,Rn.x,Rn.y,Rn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Rn.fromBufferAttribute(this,t),Rn.applyMatrix4(e),this.setXYZ(t,Rn.x,Rn.y,Rn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Rn.fromBufferAttribute(this,t),Rn.applyNormalMatrix(e),this.setXYZ(t,Rn.x,Rn.y,Rn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Rn.fromBufferAttribute(this,t),Rn.transformDirection(e),this.setXYZ(t,Rn.x,Rn.y,Rn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):qy(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Yy(e,this.array)}};var Ml=class extends pn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var wl=class extends pn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var gi=class extends pn{constructor(e,t,i){super(new Float32Array(e),t,i)}},ZT=new Us,hl=new X,Cp=new X,co=class{constructor(e=new X,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):ZT.setFromPoints(e).getCenter(i);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;hl.subVectors(e,this.center);let t=hl.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector(hl,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Cp.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(hl.copy(e.center).add(Cp)),this.expandByPoint(hl.copy(e.center).sub(Cp))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},KT=0,Qi=new Zt,Rp=new ki,ca=new X,Li=new Us,dl=new Us,$n=new X,tr=class n extends Ur{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:KT++}),this.uuid=vo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(UT(e)?wl:Ml)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new ot().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Qi.makeRotationFromQuaternion(e),this.applyMatrix4(Qi),this}rotateX(e){return Qi.makeRotationX(e),this.applyMatrix4(Qi),this}rotateY(e){return Qi.makeRotationY(e),this.applyMatrix4(Qi),this}rotateZ(e){return Qi.makeRotationZ(e),this.applyMatrix4(Qi),this}translate(e,t,i){return Qi.makeTranslation(e,t,i),this.applyMatrix4(Qi),this}scale(e,t,i){return Qi.makeScale(e,t,i),this.applyMatrix4(Qi),this}lookAt(e){return Rp.lookAt(e),Rp.updateMatrix(),this.applyMatrix4(Rp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ca).negate(),this.translate(ca.x,ca.y,ca.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new gi(i,3))}else{let i=Math.min(e.length,t.count);for(let r=0;r<i;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&Ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Us);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){st("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,r=t.length;i<r;i++){let s=t[i];Li.setFromBufferAttribute(s),this.morphTargetsRelative?($n.addVectors(this.boundingBox.min,Li.min),this.boundingBox.expandByPoint($n),$n.addVectors(this.boundingBox.max,Li.max),this.boundingBox.expandByPoint($n)):(this.boundingBox.expandByPoint(Li.min),this.boundingBox.expandByPoint(Li.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&st('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new co);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){st("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(e){let i=this.boundingSphere.center;if(Li.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];dl.setFromBufferAttribute(a),this.morphTargetsRelative?($n.addVectors(Li.min,dl.min),Li.expandByPoint($n),$n.addVectors(Li.max,dl.max),Li.expandByPoint($n)):(Li.expandByPoint(dl.min),Li.expandByPoint(dl.max))}Li.getCenter(i);let r=0;for(let s=0,o=e.count;s<o;s++)$n.fromBufferAttribute(e,s),r=Math.max(r,i.distanceToSquared($n));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)$n.fromBufferAttribute(a,c),l&&(ca.fromBufferAttribute(e,c),$n.add(ca)),r=Math.max(r,i.distanceToSquared($n))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&st('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){st("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new pn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let G=0;G<i.count;G++)a[G]=new X,l[G]=new X;let h=new X,f=new X,d=new X,p=new Et,m=new Et,x=new Et,_=new X,g=new X;function v(G,F,D){c[G]=c[F]=c[D]=1,h.fromBufferAttribute(i,G),f.fromBufferAttribute(i,F),d.fromBufferAttribute(i,D),p.fromBufferAttribute(s,G),m.fromBufferAttribute(s,F),x.fromBufferAttribute(s,D),f.sub(h),d.sub(h),m.sub(p),x.sub(p);let H=1/(m.x*x.y-x.x*m.y);isFinite(H)&&(_.copy(f).multiplyScalar(x.y).addScaledVector(d,-m.y).multiplyScalar(H),g.copy(d).multiplyScalar(m.x).addScaledVector(f,-x.x).multiplyScalar(H),a[G].add(_),a[F].add(_),a[D].add(_),l[G].add(g),l[F].add(g),l[D].add(g))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let G=0,F=E.length;G<F;++G){let D=E[G],H=D.start,V=D.count;for(let N=H,W=H+V;N<W;N+=3)v(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let M=new X,I=new X,C=new X,b=new X;function A(G){C.fromBufferAttribute(r,G),b.copy(C);let F=a[G];M.copy(F),M.sub(C.multiplyScalar(C.dot(F))).normalize(),I.crossVectors(b,F);let H=I.dot(l[G])<0?-1:1;o.setXYZW(G,M.x,M.y,M.z,H)}for(let G=0,F=i.count;G<F;++G)c[G]&&A(G);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new pn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,p=i.count;d<p;d++)i.setXYZ(d,0,0,0);let r=new X,s=new X,o=new X,a=new X,l=new X,c=new X,h=new X,f=new X;if(e)for(let d=0,p=e.count;d<p;d+=3){let m=e.getX(d+0),x=e.getX(d+1),_=e.getX(d+2);r.fromBufferAttribute(t,m),s.fromBufferAttribute(t,x),o.fromBufferAttribute(t,_),h.subVectors(o,s),f.subVectors(r,s),h.cross(f),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,_),a.add(h),l.add(h),c.add(h),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(_,c.x,c.y,c.z)}else for(let d=0,p=t.count;d<p;d+=3)r.fromBufferAttribute(t,d+0),s.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,s),f.subVectors(r,s),h.cross(f),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)$n.fromBufferAttribute(e,t),$n.normalize(),e.setXYZ(t,$n.x,$n.y,$n.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,f=a.normalized,d=new c.constructor(l.length*h),p=0,m=0;for(let x=0,_=l.length;x<_;x++){a.isInterleavedBufferAttribute?p=l[x]*a.data.stride+a.offset:p=l[x]*h;for(let g=0;g<h;g++)d[m++]=c[p++]}return new pn(d,h,f)}if(this.index===null)return Ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=e(l,i);t.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let h=0,f=c.length;h<f;h++){let d=c[h],p=e(d,i);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let f=0,d=c.length;f<d;f++){let p=c[f];h.push(p.toJSON(e.data))}h.length>0&&(r[l]=h,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let r=e.attributes;for(let c in r){let h=r[c];this.setAttribute(c,h.clone(t))}let s=e.morphAttributes;for(let c in s){let h=[],f=s[c];for(let d=0,p=f.length;d<p;d++)h.push(f[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Uu=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=fm,this.updateRanges=[],this.version=0,this.uuid=vo()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let r=0,s=this.stride;r<s;r++)this.array[e+r]=t.array[i+r];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Jx(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),r=new this.constructor(i,this.stride);return r.setUsage(this.usage),r}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Jx(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Jx(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=vo()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var hi=new X,uo=class n{constructor(e,t,i,r=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=r,this._normalizationScale=e!==void 0?Hh(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)hi.fromBufferAttribute(this,t),hi.applyMatrix4(e),this.setXYZ(t,hi.x,hi.y,hi.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)hi.fromBufferAttribute(this,t),hi.applyNormalMatrix(e),this.setXYZ(t,hi.x,hi.y,hi.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)hi.fromBufferAttribute(this,t),hi.transformDirection(e),this.setXYZ(t,hi.x,hi.y,hi.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=r,this.data.array[e+3]=s,this}clone(e){if(e===void 0){yl("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let r=i*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return new pn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){yl("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let r=i*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):qy(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Yy(e,this.data.array)}},Pp=new X,jT=new X,QT=new ot,Ni=class{constructor(e=new X(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=Pp.subVectors(i,t).cross(jT.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta(Pp),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||QT.getNormalMatrix(e),r=this.coplanarPoint(Pp).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},eA=0,ks=class extends Ur{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:eA++}),this.uuid=vo(),this.name="",this.type="Material",this.blending=Aa,this.side=Hs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=$p,this.blendDst=Xp,this.blendEquation=go,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ct(0,0,0),this.blendAlpha=0,this.depthFunc=ga,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Uy,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=bu,this.stencilZFail=bu,this.stencilZPass=bu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ke(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ct().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Ni().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Et().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Et().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var is=new X,Ip=new X,ru=new X,su=new X,Tl=class{constructor(e=new X,t=new X(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,is)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=is.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(is.copy(this.origin).addScaledVector(this.direction,t),is.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){Ip.copy(e).add(t).multiplyScalar(.5),ru.copy(t).sub(e).normalize(),su.copy(this.origin).sub(Ip);let s=e.distanceTo(t)*.5,o=-this.direction.dot(ru),a=su.dot(this.direction),l=-su.dot(ru),c=su.lengthSq(),h=Math.abs(1-o*o),f,d,p,m;if(h>0)if(f=o*l-a,d=o*a-l,m=s*h,f>=0)if(d>=-m)if(d<=m){let x=1/h;f*=x,d*=x,p=f*(f+o*d+2*a)+d*(o*f+d+2*l)+c}else d=s,f=Math.max(0,-(o*d+a)),p=-f*f+d*(d+2*l)+c;else d=-s,f=Math.max(0,-(o*d+a)),p=-f*f+d*(d+2*l)+c;else d<=-m?(f=Math.max(0,-(-o*s+a)),d=f>0?-s:Math.min(Math.max(-s,-l),s),p=-f*f+d*(d+2*l)+c):d<=m?(f=0,d=Math.min(Math.max(-s,-l),s),p=d*(d+2*l)+c):(f=Math.max(0,-(o*s+a)),d=f>0?s:Math.min(Math.max(-s,-l),s),p=-f*f+d*(d+2*l)+c);else d=o>0?-s:s,f=Math.max(0,-(o*d+a)),p=-f*f+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),r&&r.copy(Ip).addScaledVector(ru,d),p}intersectSphere(e,t){if(e.radius<0)return null;is.subVectors(e.center,this.origin);let i=is.dot(this.direction),r=is.dot(is)-i*i,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,s,o,a,l,c=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,r=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,r=(e.min.x-d.x)*c),h>=0?(s=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(s=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),f>=0?(a=(e.min.z-d.z)*f,l=(e.max.z-d.z)*f):(a=(e.max.z-d.z)*f,l=(e.min.z-d.z)*f),i>l||a>r)||((a>i||i!==i)&&(i=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,is)!==null}intersectTriangle(e,t,i,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,f=e.x-o.x,d=e.y-o.y,p=e.z-o.z,m=t.x-o.x,x=t.y-o.y,_=t.z-o.z,g=i.x-o.x,v=i.y-o.y,E=i.z-o.z,M=Math.abs(l),I=Math.abs(c),C=Math.abs(h),b,A,G,F,D,H,V,N,W,K,z,ue;if(M>=I&&M>=C?(G=l,H=f,W=m,ue=g,l>=0?(b=c,A=h,F=d,D=p,V=x,N=_,K=v,z=E):(b=h,A=c,F=p,D=d,V=_,N=x,K=E,z=v)):I>=C?(G=c,H=d,W=x,ue=v,c>=0?(b=h,A=l,F=p,D=f,V=_,N=m,K=E,z=g):(b=l,A=h,F=f,D=p,V=m,N=_,K=g,z=E)):(G=h,H=p,W=_,ue=E,h>=0?(b=l,A=c,F=f,D=d,V=m,N=x,K=g,z=v):(b=c,A=l,F=d,D=f,V=x,N=m,K=v,z=g)),G===0)return null;let j=b/G,ee=A/G,se=1/G,fe=F-j*H,de=D-ee*H,te=V-j*W,_e=N-ee*W,ve=K-j*ue,Re=z-ee*ue,we=ve*_e-Re*te,qe=fe*Re-de*ve,ct=te*de-_e*fe;if(r){if(we<0||qe<0||ct<0)return null}else if((we<0||qe<0||ct<0)&&(we>0||qe>0||ct>0))return null;let $e=we+qe+ct;if($e===0)return null;let _t=se*(we*H+qe*W+ct*ue);return($e>0?_t<0:_t>0)?null:this.at(_t/$e,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ku=class extends ks{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Fs,this.combine=qp,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Zx=new Zt,so=new Tl,ou=new co,Kx=new X,au=new X,lu=new X,cu=new X,Lp=new X,uu=new X,jx=new X,hu=new X,Jn=class extends ki{constructor(e=new tr,t=new ku){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){uu.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let h=a[l],f=s[l];h!==0&&(Lp.fromBufferAttribute(f,e),o?uu.addScaledVector(Lp,h):uu.addScaledVector(Lp.sub(t),h))}t.add(uu)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),ou.copy(i.boundingSphere),ou.applyMatrix4(s),so.copy(e.ray).recast(e.near),!(ou.containsPoint(so.origin)===!1&&(so.intersectSphere(ou,Kx)===null||so.origin.distanceToSquared(Kx)>(e.far-e.near)**2))&&(Zx.copy(s).invert(),so.copy(e.ray).applyMatrix4(Zx),!(i.boundingBox!==null&&so.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,so)))}_computeIntersections(e,t,i){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,h=s.attributes.uv1,f=s.attributes.normal,d=s.groups,p=s.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,x=d.length;m<x;m++){let _=d[m],g=o[_.materialIndex],v=Math.max(_.start,p.start),E=Math.min(a.count,Math.min(_.start+_.count,p.start+p.count));for(let M=v,I=E;M<I;M+=3){let C=a.getX(M),b=a.getX(M+1),A=a.getX(M+2);r=du(this,g,e,i,c,h,f,C,b,A),r&&(r.faceIndex=Math.floor(M/3),r.face.materialIndex=_.materialIndex,t.push(r))}}else{let m=Math.max(0,p.start),x=Math.min(a.count,p.start+p.count);for(let _=m,g=x;_<g;_+=3){let v=a.getX(_),E=a.getX(_+1),M=a.getX(_+2);r=du(this,o,e,i,c,h,f,v,E,M),r&&(r.faceIndex=Math.floor(_/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,x=d.length;m<x;m++){let _=d[m],g=o[_.materialIndex],v=Math.max(_.start,p.start),E=Math.min(l.count,Math.min(_.start+_.count,p.start+p.count));for(let M=v,I=E;M<I;M+=3){let C=M,b=M+1,A=M+2;r=du(this,g,e,i,c,h,f,C,b,A),r&&(r.faceIndex=Math.floor(M/3),r.face.materialIndex=_.materialIndex,t.push(r))}}else{let m=Math.max(0,p.start),x=Math.min(l.count,p.start+p.count);for(let _=m,g=x;_<g;_+=3){let v=_,E=_+1,M=_+2;r=du(this,o,e,i,c,h,f,v,E,M),r&&(r.faceIndex=Math.floor(_/3),t.push(r))}}}};function tA(n,e,t,i,r,s,o,a){let l;if(e.side===fi?l=i.intersectTriangle(o,s,r,!0,a):l=i.intersectTriangle(r,s,o,e.side===Hs,a),l===null)return null;hu.copy(a),hu.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(hu);return c<t.near||c>t.far?null:{distance:c,point:hu.clone(),object:n}}function du(n,e,t,i,r,s,o,a,l,c){n.getVertexPosition(a,au),n.getVertexPosition(l,lu),n.getVertexPosition(c,cu);let h=tA(n,e,t,i,au,lu,cu,jx);if(h){let f=new X;Nr.getBarycoord(jx,au,lu,cu,f),r&&(h.uv=Nr.getInterpolatedAttribute(r,a,l,c,f,new Et)),s&&(h.uv1=Nr.getInterpolatedAttribute(s,a,l,c,f,new Et)),o&&(h.normal=Nr.getInterpolatedAttribute(o,a,l,c,f,new X),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new X,materialIndex:0};Nr.getNormal(au,lu,cu,d.normal),h.face=d,h.barycoord=f}return h}var va=class extends _i{constructor(e=null,t=1,i=1,r,s,o,a,l,c=Xn,h=Xn,f,d){super(null,o,a,l,c,h,r,s,f,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Os=class extends pn{constructor(e,t,i,r=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var oo=new co,nA=new Et(.5,.5),fu=new X,ho=class{constructor(e=new Ni,t=new Ni,i=new Ni,r=new Ni,s=new Ni,o=new Ni){this.planes=[e,t,i,r,s,o]}set(e,t,i,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=er,i=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],l=s[2],c=s[3],h=s[4],f=s[5],d=s[6],p=s[7],m=s[8],x=s[9],_=s[10],g=s[11],v=s[12],E=s[13],M=s[14],I=s[15];if(r[0].setComponents(c-o,p-h,g-m,I-v).normalize(),r[1].setComponents(c+o,p+h,g+m,I+v).normalize(),r[2].setComponents(c+a,p+f,g+x,I+E).normalize(),r[3].setComponents(c-a,p-f,g-x,I-E).normalize(),i)r[4].setComponents(l,d,_,M).normalize(),r[5].setComponents(c-l,p-d,g-_,I-M).normalize();else if(r[4].setComponents(c-l,p-d,g-_,I-M).normalize(),t===er)r[5].setComponents(c+l,p+d,g+_,I+M).normalize();else if(t===_l)r[5].setComponents(l,d,_,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),oo.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),oo.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(oo)}intersectsSprite(e){oo.center.set(0,0,0);let t=nA.distanceTo(e.center);return oo.radius=.7071067811865476+t,oo.applyMatrix4(e.matrixWorld),this.intersectsSphere(oo)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(fu.x=r.normal.x>0?e.max.x:e.min.x,fu.y=r.normal.y>0?e.max.y:e.min.y,fu.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(fu)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Qx=new Zt,Ou=class n{constructor(){this.coordinateSystem=er,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];Qx.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new ho),i[r].setFromProjectionMatrix(Qx,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new ho),t[r].copy(i[r]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Bu=class extends ks{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ct(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Vu=new X,zu=new X,ey=new Zt,fl=new Tl,pu=new co,Dp=new X,ty=new X,Hu=class extends ki{constructor(e=new tr,t=new Bu){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let r=1,s=t.count;r<s;r++)Vu.fromBufferAttribute(t,r-1),zu.fromBufferAttribute(t,r),i[r]=i[r-1],i[r]+=Vu.distanceTo(zu);e.setAttribute("lineDistance",new gi(i,1))}else Ke("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.matrixWorld,s=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),pu.copy(i.boundingSphere),pu.applyMatrix4(r),pu.radius+=s,e.ray.intersectsSphere(pu)===!1)return;ey.copy(r).invert(),fl.copy(e.ray).applyMatrix4(ey);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,d=i.attributes.position;if(h!==null){let p=Math.max(0,o.start),m=Math.min(h.count,o.start+o.count);for(let x=p,_=m-1;x<_;x+=c){let g=h.getX(x),v=h.getX(x+1),E=mu(this,e,fl,l,g,v,x);E&&t.push(E)}if(this.isLineLoop){let x=h.getX(m-1),_=h.getX(p),g=mu(this,e,fl,l,x,_,m-1);g&&t.push(g)}}else{let p=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let x=p,_=m-1;x<_;x+=c){let g=mu(this,e,fl,l,x,x+1,x);g&&t.push(g)}if(this.isLineLoop){let x=mu(this,e,fl,l,m-1,p,m-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function mu(n,e,t,i,r,s,o){let a=n.geometry.attributes.position;if(Vu.fromBufferAttribute(a,r),zu.fromBufferAttribute(a,s),t.distanceSqToSegment(Vu,zu,Dp,ty)>i)return;Dp.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Dp);if(!(c<e.near||c>e.far))return{distance:c,point:ty.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var ny=new X,iy=new X,Al=class extends Hu{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let r=0,s=t.count;r<s;r+=2)ny.fromBufferAttribute(t,r),iy.fromBufferAttribute(t,r+1),i[r]=r===0?0:i[r-1],i[r+1]=i[r]+ny.distanceTo(iy);e.setAttribute("lineDistance",new gi(i,1))}else Ke("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var El=class extends _i{constructor(e=[],t=_o,i,r,s,o,a,l,c,h){super(e,t,i,r,s,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var os=class extends _i{constructor(e,t,i=_r,r,s,o,a=Xn,l=Xn,c,h=ss,f=1){if(h!==ss&&h!==ls)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:f};super(d,r,s,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new xa(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Cl=class extends os{constructor(e,t=_r,i=_o,r,s,o=Xn,a=Xn,l,c=ss){let h={width:e,height:e,depth:1},f=[h,h,h,h,h,h];super(e,e,t,i,r,s,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Rl=class extends _i{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ba=class n extends tr{constructor(e=1,t=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],h=[],f=[],d=0,p=0;m("z","y","x",-1,-1,i,t,e,o,s,0),m("z","y","x",1,-1,i,t,-e,o,s,1),m("x","z","y",1,1,e,i,t,r,o,2),m("x","z","y",1,-1,e,i,-t,r,o,3),m("x","y","z",1,-1,e,t,i,r,s,4),m("x","y","z",-1,-1,e,t,-i,r,s,5),this.setIndex(l),this.setAttribute("position",new gi(c,3)),this.setAttribute("normal",new gi(h,3)),this.setAttribute("uv",new gi(f,2));function m(x,_,g,v,E,M,I,C,b,A,G){let F=M/b,D=I/A,H=M/2,V=I/2,N=C/2,W=b+1,K=A+1,z=0,ue=0,j=new X;for(let ee=0;ee<K;ee++){let se=ee*D-V;for(let fe=0;fe<W;fe++){let de=fe*F-H;j[x]=de*v,j[_]=se*E,j[g]=N,c.push(j.x,j.y,j.z),j[x]=0,j[_]=0,j[g]=C>0?1:-1,h.push(j.x,j.y,j.z),f.push(fe/b),f.push(1-ee/A),z+=1}}for(let ee=0;ee<A;ee++)for(let se=0;se<b;se++){let fe=d+se+W*ee,de=d+se+W*(ee+1),te=d+(se+1)+W*(ee+1),_e=d+(se+1)+W*ee;l.push(fe,de,_e),l.push(de,te,_e),ue+=6}a.addGroup(p,ue,G),p+=ue,d+=z}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Pl=class n extends tr{constructor(e=1,t=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(i),l=Math.floor(r),c=a+1,h=l+1,f=e/a,d=t/l,p=[],m=[],x=[],_=[];for(let g=0;g<h;g++){let v=g*d-o;for(let E=0;E<c;E++){let M=E*f-s;m.push(M,-v,0),x.push(0,0,1),_.push(E/a),_.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<a;v++){let E=v+c*g,M=v+c*(g+1),I=v+1+c*(g+1),C=v+1+c*g;p.push(E,M,C),p.push(M,I,C)}this.setIndex(p),this.setAttribute("position",new gi(m,3)),this.setAttribute("normal",new gi(x,3)),this.setAttribute("uv",new gi(_,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};function bo(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let r=n[t][i];if(ry(r))r.isRenderTargetTexture?(Ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=r.clone();else if(Array.isArray(r))if(ry(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][i]=s}else e[t][i]=r.slice();else e[t][i]=r}}return e}function ni(n){let e={};for(let t=0;t<n.length;t++){let i=bo(n[t]);for(let r in i)e[r]=i[r]}return e}function ry(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function iA(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function pm(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:bt.workingColorSpace}var Zy={clone:bo,merge:ni},rA=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,sA=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Or=class extends ks{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=rA,this.fragmentShader=sA,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=bo(e.uniforms),this.uniformsGroups=iA(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new Ct().setHex(r.value);break;case"v2":this.uniforms[i].value=new Et().fromArray(r.value);break;case"v3":this.uniforms[i].value=new X().fromArray(r.value);break;case"v4":this.uniforms[i].value=new ln().fromArray(r.value);break;case"m3":this.uniforms[i].value=new ot().fromArray(r.value);break;case"m4":this.uniforms[i].value=new Zt().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Sa=class extends Or{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Gu=class extends ks{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Ny,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Wu=class extends ks{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function ua(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function gu(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Bs=class{constructor(e,t,i,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,r=t[i],s=t[i-1];e:{t:{let o;n:{i:if(!(e<r)){for(let a=i+2;;){if(r===void 0){if(e<s)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(s=r,r=t[++i],e<r)break t}o=t.length;break n}if(!(e>=s)){let a=t[1];e<a&&(i=2,s=a);for(let l=i-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(r=s,s=t[--i-1],e>=s)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(r=t[i],s=t[i-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,s,r)}return this.interpolate_(i,s,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,r=this.valueSize,s=e*r;for(let o=0;o!==r;++o)t[o]=i[s+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},$u=class extends Bs{constructor(e,t,i,r){super(e,t,i,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Up,endingEnd:Up}}intervalChanged_(e,t,i){let r=this.parameterPositions,s=e-2,o=e+1,a=r[s],l=r[o];if(a===void 0)switch(this.getSettings_().endingStart){case kp:s=e,a=2*t-i;break;case Op:s=r.length-2,a=t+r[s]-r[s+1];break;default:s=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case kp:o=e,l=2*i-t;break;case Op:o=1,l=i+r[1]-r[0];break;default:o=e-1,l=t}let c=(i-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=s*h,this._offsetNext=o*h}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,f=this._offsetNext,d=this._weightPrev,p=this._weightNext,m=(i-t)/(r-t),x=m*m,_=x*m,g=-d*_+2*d*x-d*m,v=(1+d)*_+(-1.5-2*d)*x+(-.5+d)*m+1,E=(-1-p)*_+(1.5+p)*x+.5*m,M=p*_-p*x;for(let I=0;I!==a;++I)s[I]=g*o[h+I]+v*o[c+I]+E*o[l+I]+M*o[f+I];return s}},Xu=class extends Bs{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(i-t)/(r-t),f=1-h;for(let d=0;d!==a;++d)s[d]=o[c+d]*f+o[l+d]*h;return s}},qu=class extends Bs{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e){return this.copySampleValue_(e-1)}},Yu=class extends Bs{interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,f=this.outTangents;if(!h||!f){let m=(i-t)/(r-t),x=1-m;for(let _=0;_!==a;++_)s[_]=o[c+_]*x+o[l+_]*m;return s}let d=a*2,p=e-1;for(let m=0;m!==a;++m){let x=o[c+m],_=o[l+m],g=p*d+m*2,v=f[g],E=f[g+1],M=e*d+m*2,I=h[M],C=h[M+1],b=aA(i,t,v,I,r);s[m]=Ky(b,x,E,C,_)}return s}};function Ky(n,e,t,i,r){let s=1-n;return s*s*s*e+3*s*s*n*t+3*s*n*n*i+n*n*n*r}function oA(n,e,t,i,r){let s=1-n;return 3*s*s*(t-e)+6*s*n*(i-t)+3*n*n*(r-i)}function aA(n,e,t,i,r){let s=(n-e)/(r-e);for(let o=0;o<8;o++){let a=Ky(s,e,t,i,r)-n;if(Math.abs(a)<1e-10)break;let l=oA(s,e,t,i,r);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-a/l))}return s}var Oi=class{constructor(e,t,i,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=ua(t,this.TimeBufferType),this.values=ua(i,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:ua(e.times,Array),values:ua(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(i.interpolation=r),gu(e.settings)&&(i.settings={inTangents:ua(e.settings.inTangents,Array),outTangents:ua(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new qu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Xu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new $u(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Yu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ml:t=this.InterpolantFactoryMethodDiscrete;break;case Iu:t=this.InterpolantFactoryMethodLinear;break;case vu:t=this.InterpolantFactoryMethodSmooth;break;case Fp:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ke("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ml;case this.InterpolantFactoryMethodLinear:return Iu;case this.InterpolantFactoryMethodSmooth:return vu;case this.InterpolantFactoryMethodBezier:return Fp}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]+=e;gu(this.settings)&&(sy(this.settings.inTangents,e),sy(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]*=e;gu(this.settings)&&(oy(this.settings.inTangents,e),oy(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,r=i.length,s=0,o=r-1;for(;s!==r&&i[s]<e;)++s;for(;o!==-1&&i[o]>t;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=i.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(st("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,r=this.values,s=i.length;s===0&&(st("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==s;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){st("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){st("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(r!==void 0&&kT(r))for(let a=0,l=r.length;a!==l;++a){let c=r[a];if(isNaN(c)){st("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),r=this.getInterpolation()===vu,s=e.length-1,o=1;for(let a=1;a<s;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(r)l=!0;else{let f=a*i,d=f-i,p=f+i;for(let m=0;m!==i;++m){let x=t[f+m];if(x!==t[d+m]||x!==t[p+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*i,d=o*i;for(let p=0;p!==i;++p)t[d+p]=t[f+p]}++o}}if(s>0){e[o]=e[s];for(let a=s*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,r=new i(this.name,e,t);return r.createInterpolant=this.createInterpolant,gu(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function sy(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function oy(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Oi.prototype.ValueTypeName="";Oi.prototype.TimeBufferType=Float32Array;Oi.prototype.ValueBufferType=Float32Array;Oi.prototype.DefaultInterpolation=Iu;var Vs=class extends Oi{constructor(e,t,i){super(e,t,i)}};Vs.prototype.ValueTypeName="bool";Vs.prototype.ValueBufferType=Array;Vs.prototype.DefaultInterpolation=ml;Vs.prototype.InterpolantFactoryMethodLinear=void 0;Vs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ju=class extends Oi{constructor(e,t,i,r){super(e,t,i,r)}};Ju.prototype.ValueTypeName="color";var Zu=class extends Oi{constructor(e,t,i,r){super(e,t,i,r)}};Zu.prototype.ValueTypeName="number";var Ku=class extends Bs{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(r-t),c=e*a;for(let h=c+a;c!==h;c+=4)kr.slerpFlat(s,0,o,c-a,o,c,l);return s}},Il=class extends Oi{constructor(e,t,i,r){super(e,t,i,r)}InterpolantFactoryMethodLinear(e){return new Ku(this.times,this.values,this.getValueSize(),e)}};Il.prototype.ValueTypeName="quaternion";Il.prototype.InterpolantFactoryMethodSmooth=void 0;var zs=class extends Oi{constructor(e,t,i){super(e,t,i)}};zs.prototype.ValueTypeName="string";zs.prototype.ValueBufferType=Array;zs.prototype.DefaultInterpolation=ml;zs.prototype.InterpolantFactoryMethodLinear=void 0;zs.prototype.InterpolantFactoryMethodSmooth=void 0;var ju=class extends Oi{constructor(e,t,i,r){super(e,t,i,r)}};ju.prototype.ValueTypeName="vector";var Qu=class{constructor(e,t,i){let r=this,s=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,s===!1&&r.onStart!==void 0&&r.onStart(h,o,a),s=!0},this.itemEnd=function(h){o++,r.onProgress!==void 0&&r.onProgress(h,o,a),o===a&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(h){r.onError!==void 0&&r.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,f){return c.push(h,f),this},this.removeHandler=function(h){let f=c.indexOf(h);return f!==-1&&c.splice(f,2),this},this.getHandler=function(h){for(let f=0,d=c.length;f<d;f+=2){let p=c[f],m=c[f+1];if(p.global&&(p.lastIndex=0),p.test(h))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},jy=new Qu,eh=class{constructor(e){this.manager=e!==void 0?e:jy,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(r,s){i.load(e,r,t,s)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};eh.DEFAULT_MATERIAL_NAME="__DEFAULT";var _u=new X,xu=new kr,Dr=new X,fo=class extends ki{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Zt,this.projectionMatrix=new Zt,this.projectionMatrixInverse=new Zt,this.coordinateSystem=er,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(_u,xu,Dr),Dr.x===1&&Dr.y===1&&Dr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(_u,xu,Dr.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(_u,xu,Dr),Dr.x===1&&Dr.y===1&&Dr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(_u,xu,Dr.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ns=new X,ay=new Et,ly=new Et,Fi=class extends fo{constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Lu*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(dp*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Lu*2*Math.atan(Math.tan(dp*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Ns.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ns.x,Ns.y).multiplyScalar(-e/Ns.z),Ns.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ns.x,Ns.y).multiplyScalar(-e/Ns.z)}getViewSize(e,t){return this.getViewBounds(e,ay,ly),t.subVectors(ly,ay)}setViewOffset(e,t,i,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(dp*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,t-=o.offsetY*i/c,r*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var th=class extends fo{constructor(e=-1,t=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-e,o=i+e,a=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var po=class extends tr{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var ha=-90,da=1,Ma=class extends ki{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Fi(ha,da,e,t);r.layers=this.layers,this.add(r);let s=new Fi(ha,da,e,t);s.layers=this.layers,this.add(s);let o=new Fi(ha,da,e,t);o.layers=this.layers,this.add(o);let a=new Fi(ha,da,e,t);a.layers=this.layers,this.add(a);let l=new Fi(ha,da,e,t);l.layers=this.layers,this.add(l);let c=new Fi(ha,da,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,s,o,a,l]=t;for(let c of t)this.remove(c);if(e===er)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===_l)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,h]=this.children,f=e.getRenderTarget(),d=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let _=!1;e.isWebGLRenderer===!0?_=e.state.buffers.depth.getReversed():_=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,r),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,r),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,r),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,r),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,r),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(f,d,p),e.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},nh=class extends Fi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var mm="\\[\\]\\.:\\/",lA=new RegExp("["+mm+"]","g"),gm="[^"+mm+"]",cA="[^"+mm.replace("\\.","")+"]",uA=/((?:WC+[\/:])*)/.source.replace("WC",gm),hA=/(WCOD+)?/.source.replace("WCOD",cA),dA=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",gm),fA=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",gm),pA=new RegExp("^"+uA+hA+dA+fA+"$"),mA=["material","materials","bones","map"],Bp=class{constructor(e,t,i){let r=i||nn.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,r=this._bindings[i];r!==void 0&&r.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=i.length;r!==s;++r)i[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},nn=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(lA,"")}static parseTrackName(e){let t=pA.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=i.nodeName&&i.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=i.nodeName.substring(r+1);mA.indexOf(s)!==-1&&(i.nodeName=i.nodeName.substring(0,r),i.objectName=s)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},r=i(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)e[t++]=i[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,r=t.propertyName,s=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ke("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){st("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){st("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){st("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){st("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){st("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){st("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){st("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[r];if(o===void 0){let c=t.nodeName;st("PropertyBinding: Trying to update property for track: "+c+"."+r+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){st("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){st("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[s]!==void 0&&(s=e.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};nn.Composite=Bp;nn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};nn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};nn.prototype.GetterByBindingType=[nn.prototype._getValue_direct,nn.prototype._getValue_array,nn.prototype._getValue_arrayElement,nn.prototype._getValue_toArray];nn.prototype.SetterByBindingTypeAndVersioning=[[nn.prototype._setValue_direct,nn.prototype._setValue_direct_setNeedsUpdate,nn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_array,nn.prototype._setValue_array_setNeedsUpdate,nn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_arrayElement,nn.prototype._setValue_arrayElement_setNeedsUpdate,nn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_fromArray,nn.prototype._setValue_fromArray_setNeedsUpdate,nn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var VN=new Float32Array(1);var wa=class extends Uu{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var Vp=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,r){let s=this.elements;return s[0]=e,s[2]=t,s[1]=i,s[3]=r,this}};var cy=new X,yu=new X,fa=new X,pa=new X,Np=new X,gA=new X,_A=new X,Ll=class{constructor(e=new X,t=new X){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){cy.subVectors(e,this.start),yu.subVectors(this.end,this.start);let i=yu.dot(yu);if(i===0)return 0;let s=yu.dot(cy)/i;return t&&(s=dt(s,0,1)),s}closestPointToPoint(e,t,i){let r=this.closestPointToPointParameter(e,t);return this.delta(i).multiplyScalar(r).add(this.start)}distanceSqToLine3(e,t=gA,i=_A){let r=10000000000000001e-32,s,o,a=this.start,l=e.start,c=this.end,h=e.end;fa.subVectors(c,a),pa.subVectors(h,l),Np.subVectors(a,l);let f=fa.dot(fa),d=pa.dot(pa),p=pa.dot(Np);if(f<=r&&d<=r)return t.copy(a),i.copy(l),t.distanceToSquared(i);if(f<=r)s=0,o=p/d,o=dt(o,0,1);else{let m=fa.dot(Np);if(d<=r)o=0,s=dt(-m/f,0,1);else{let x=fa.dot(pa),_=f*d-x*x;_!==0?s=dt((x*p-m*d)/_,0,1):s=0,o=(x*s+p)/d,o<0?(o=0,s=dt(-m/f,0,1)):o>1&&(o=1,s=dt((x-m)/f,0,1))}}return t.copy(a).addScaledVector(fa,s),i.copy(l).addScaledVector(pa,o),t.distanceToSquared(i)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};function _m(n,e,t,i){let r=xA(i);switch(t){case om:return n*e;case lm:return n*e/r.components*r.byteLength;case ch:return n*e/r.components*r.byteLength;case Gs:return n*e*2/r.components*r.byteLength;case uh:return n*e*2/r.components*r.byteLength;case am:return n*e*3/r.components*r.byteLength;case zi:return n*e*4/r.components*r.byteLength;case hh:return n*e*4/r.components*r.byteLength;case Fl:case Ul:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case kl:case Ol:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case fh:case mh:return Math.max(n,16)*Math.max(e,8)/4;case dh:case ph:return Math.max(n,8)*Math.max(e,8)/2;case gh:case _h:case yh:case vh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case xh:case Bl:case bh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Sh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Mh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case wh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Th:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Ah:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Eh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Ch:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Rh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Ph:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Ih:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Lh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Dh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Nh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Fh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Uh:case kh:case Oh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Bh:case Vh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Vl:case zh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function xA(n){switch(n){case Bi:case nm:return{byteLength:1,components:1};case Ca:case im:case xr:return{byteLength:2,components:1};case ah:case lh:return{byteLength:2,components:4};case _r:case oh:case Vi:return{byteLength:4,components:1};case rm:case sm:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function vv(){let n=null,e=!1,t=null,i=null;function r(s,o){i=n.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(r),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){n=s}}}function vA(n){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,f=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,h),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let h=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,h);else{f.sort((p,m)=>p.start-m.start);let d=0;for(let p=1;p<f.length;p++){let m=f[d],x=f[p];x.start<=m.start+m.count+1?m.count=Math.max(m.count,x.start+x.count-m.start):(++d,f[d]=x)}f.length=d+1;for(let p=0,m=f.length;p<m;p++){let x=f[p];n.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var bA=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,SA=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,MA=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,wA=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,TA=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,AA=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,EA=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,CA=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,RA=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,PA=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,IA=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,LA=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,DA=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,NA=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,FA=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,UA=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,kA=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,OA=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,BA=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,VA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,zA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,HA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,GA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,WA=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,$A=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,XA=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,qA=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,YA=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,JA=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,ZA="gl_FragColor = linearToOutputTexel( gl_FragColor );",KA=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,jA=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,QA=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,eE=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,tE=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,nE=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,iE=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,rE=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,sE=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,oE=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,aE=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,lE=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,cE=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,uE=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,hE=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,dE=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,fE=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,pE=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,mE=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,gE=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,_E=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,xE=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,yE=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,vE=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,bE=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,SE=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,ME=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,wE=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,TE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,AE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,EE=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,CE=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,RE=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,PE=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,IE=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,LE=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,DE=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,NE=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,FE=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,UE=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,kE=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,OE=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,BE=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,VE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,zE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,HE=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,GE=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,WE=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,$E=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,XE=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,qE=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,YE=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,JE=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,ZE=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,KE=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,jE=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,QE=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,eC=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,tC=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,nC=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,iC=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,rC=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,sC=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,oC=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,aC=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,lC=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,cC=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,uC=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,hC=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,dC=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,fC=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,pC=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,mC=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,gC=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,_C=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,xC=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,yC=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,vC=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,bC=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,SC=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,MC=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,wC=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,TC=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,AC=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,EC=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,CC=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,RC=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,PC=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,IC=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,LC=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,DC=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,NC=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,FC=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,UC=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,kC=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,OC=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,BC=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,VC=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,zC=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,HC=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,GC=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,WC=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,$C=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,XC=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,qC=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,YC=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,JC=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,ZC=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,KC=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,jC=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,QC=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,gt={alphahash_fragment:bA,alphahash_pars_fragment:SA,alphamap_fragment:MA,alphamap_pars_fragment:wA,alphatest_fragment:TA,alphatest_pars_fragment:AA,aomap_fragment:EA,aomap_pars_fragment:CA,batching_pars_vertex:RA,batching_vertex:PA,begin_vertex:IA,beginnormal_vertex:LA,bsdfs:DA,iridescence_fragment:NA,bumpmap_pars_fragment:FA,clipping_planes_fragment:UA,clipping_planes_pars_fragment:kA,clipping_planes_pars_vertex:OA,clipping_planes_vertex:BA,color_fragment:VA,color_pars_fragment:zA,color_pars_vertex:HA,color_vertex:GA,common:WA,defaultnormal_vertex:$A,displacementmap_pars_vertex:XA,displacementmap_vertex:qA,emissivemap_fragment:YA,emissivemap_pars_fragment:JA,colorspace_fragment:ZA,colorspace_pars_fragment:KA,envmap_fragment:jA,envmap_common_pars_fragment:QA,envmap_pars_fragment:eE,envmap_pars_vertex:tE,envmap_physical_pars_fragment:dE,envmap_vertex:nE,fog_vertex:iE,fog_pars_vertex:rE,fog_fragment:sE,fog_pars_fragment:oE,gradientmap_pars_fragment:aE,lightmap_pars_fragment:lE,lights_lambert_fragment:cE,lights_lambert_pars_fragment:uE,lights_pars_begin:hE,lights_toon_fragment:fE,lights_toon_pars_fragment:pE,lights_phong_fragment:mE,lights_phong_pars_fragment:gE,lights_physical_fragment:_E,lights_physical_pars_fragment:xE,lights_fragment_begin:yE,lights_fragment_maps:vE,lights_fragment_end:bE,lightprobes_pars_fragment:SE,logdepthbuf_fragment:ME,logdepthbuf_pars_fragment:wE,logdepthbuf_pars_vertex:TE,logdepthbuf_vertex:AE,map_fragment:EE,map_pars_fragment:CE,map_particle_fragment:RE,map_particle_pars_fragment:PE,metalnessmap_fragment:IE,metalnessmap_pars_fragment:LE,morphinstance_vertex:DE,morphcolor_vertex:NE,morphnormal_vertex:FE,morphtarget_pars_vertex:UE,morphtarget_vertex:kE,normal_fragment_begin:OE,normal_fragment_maps:BE,normal_pars_fragment:VE,normal_pars_vertex:zE,normal_vertex:HE,normalmap_pars_fragment:GE,clearcoat_normal_fragment_begin:WE,clearcoat_normal_fragment_maps:$E,clearcoat_pars_fragment:XE,iridescence_pars_fragment:qE,opaque_fragment:YE,packing:JE,premultiplied_alpha_fragment:ZE,project_vertex:KE,dithering_fragment:jE,dithering_pars_fragment:QE,roughnessmap_fragment:eC,roughnessmap_pars_fragment:tC,shadowmap_pars_fragment:nC,shadowmap_pars_vertex:iC,shadowmap_vertex:rC,shadowmask_pars_fragment:sC,skinbase_vertex:oC,skinning_pars_vertex:aC,skinning_vertex:lC,skinnormal_vertex:cC,specularmap_fragment:uC,specularmap_pars_fragment:hC,tonemapping_fragment:dC,tonemapping_pars_fragment:fC,transmission_fragment:pC,transmission_pars_fragment:mC,uv_pars_fragment:gC,uv_pars_vertex:_C,uv_vertex:xC,worldpos_vertex:yC,background_vert:vC,background_frag:bC,backgroundCube_vert:SC,backgroundCube_frag:MC,cube_vert:wC,cube_frag:TC,depth_vert:AC,depth_frag:EC,distance_vert:CC,distance_frag:RC,equirect_vert:PC,equirect_frag:IC,linedashed_vert:LC,linedashed_frag:DC,meshbasic_vert:NC,meshbasic_frag:FC,meshlambert_vert:UC,meshlambert_frag:kC,meshmatcap_vert:OC,meshmatcap_frag:BC,meshnormal_vert:VC,meshnormal_frag:zC,meshphong_vert:HC,meshphong_frag:GC,meshphysical_vert:WC,meshphysical_frag:$C,meshtoon_vert:XC,meshtoon_frag:qC,points_vert:YC,points_frag:JC,shadow_vert:ZC,shadow_frag:KC,sprite_vert:jC,sprite_frag:QC},Ne={common:{diffuse:{value:new Ct(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ot}},envmap:{envMap:{value:null},envMapRotation:{value:new ot},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ot}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ot}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ot},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ot},normalScale:{value:new Et(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ot},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ot}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ot}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ot}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ct(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ct(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0},uvTransform:{value:new ot}},sprite:{diffuse:{value:new Ct(16777215)},opacity:{value:1},center:{value:new Et(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}}},zr={basic:{uniforms:ni([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:gt.meshbasic_vert,fragmentShader:gt.meshbasic_frag},lambert:{uniforms:ni([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new Ct(0)},envMapIntensity:{value:1}}]),vertexShader:gt.meshlambert_vert,fragmentShader:gt.meshlambert_frag},phong:{uniforms:ni([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new Ct(0)},specular:{value:new Ct(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:gt.meshphong_vert,fragmentShader:gt.meshphong_frag},standard:{uniforms:ni([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new Ct(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag},toon:{uniforms:ni([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new Ct(0)}}]),vertexShader:gt.meshtoon_vert,fragmentShader:gt.meshtoon_frag},matcap:{uniforms:ni([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:gt.meshmatcap_vert,fragmentShader:gt.meshmatcap_frag},points:{uniforms:ni([Ne.points,Ne.fog]),vertexShader:gt.points_vert,fragmentShader:gt.points_frag},dashed:{uniforms:ni([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:gt.linedashed_vert,fragmentShader:gt.linedashed_frag},depth:{uniforms:ni([Ne.common,Ne.displacementmap]),vertexShader:gt.depth_vert,fragmentShader:gt.depth_frag},normal:{uniforms:ni([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:gt.meshnormal_vert,fragmentShader:gt.meshnormal_frag},sprite:{uniforms:ni([Ne.sprite,Ne.fog]),vertexShader:gt.sprite_vert,fragmentShader:gt.sprite_frag},background:{uniforms:{uvTransform:{value:new ot},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:gt.background_vert,fragmentShader:gt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ot}},vertexShader:gt.backgroundCube_vert,fragmentShader:gt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:gt.cube_vert,fragmentShader:gt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:gt.equirect_vert,fragmentShader:gt.equirect_frag},distance:{uniforms:ni([Ne.common,Ne.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:gt.distance_vert,fragmentShader:gt.distance_frag},shadow:{uniforms:ni([Ne.lights,Ne.fog,{color:{value:new Ct(0)},opacity:{value:1}}]),vertexShader:gt.shadow_vert,fragmentShader:gt.shadow_frag}};zr.physical={uniforms:ni([zr.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ot},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ot},clearcoatNormalScale:{value:new Et(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ot},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ot},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ot},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ot},sheen:{value:0},sheenColor:{value:new Ct(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ot},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ot},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ot},transmissionSamplerSize:{value:new Et},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ot},attenuationDistance:{value:0},attenuationColor:{value:new Ct(0)},specularColor:{value:new Ct(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ot},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ot},anisotropyVector:{value:new Et},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ot}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag};var Gh={r:0,b:0,g:0},eR=new Zt,bv=new ot;bv.set(-1,0,0,0,1,0,0,0,1);function tR(n,e,t,i,r,s){let o=new Ct(0),a=r===!0?0:1,l,c,h=null,f=0,d=null;function p(v){let E=v.isScene===!0?v.background:null;if(E&&E.isTexture){let M=v.backgroundBlurriness>0;E=e.get(E,M)}return E}function m(v){let E=!1,M=p(v);M===null?_(o,a):M&&M.isColor&&(_(M,1),E=!0);let I=n.xr.getEnvironmentBlendMode();I==="additive"?t.buffers.color.setClear(0,0,0,1,s):I==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||E)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(v,E){let M=p(E);M&&M.isCubeTexture?(c===void 0&&(c=new Jn(new ba(1,1,1),new Or({name:"BackgroundCubeMaterial",uniforms:bo(zr.backgroundCube.uniforms),vertexShader:zr.backgroundCube.vertexShader,fragmentShader:zr.backgroundCube.fragmentShader,side:fi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(I,C,b){this.matrixWorld.copyPosition(b.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(eR.makeRotationFromEuler(E.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(bv),c.material.toneMapped=bt.getTransfer(M.colorSpace)!==kt,(h!==M||f!==M.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=M,f=M.version,d=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new Jn(new Pl(2,2),new Or({name:"BackgroundMaterial",uniforms:bo(zr.background.uniforms),vertexShader:zr.background.vertexShader,fragmentShader:zr.background.fragmentShader,side:Hs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=bt.getTransfer(M.colorSpace)!==kt,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||f!==M.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,h=M,f=M.version,d=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function _(v,E){v.getRGB(Gh,pm(n)),t.buffers.color.setClear(Gh.r,Gh.g,Gh.b,E,s)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,E=1){o.set(v),a=E,_(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,_(o,a)},render:m,addToRenderList:x,dispose:g}}function nR(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},r=d(null),s=r,o=!1;function a(D,H,V,N,W){let K=!1,z=f(D,N,V,H);s!==z&&(s=z,c(s.object)),K=p(D,N,V,W),K&&m(D,N,V,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(K||o)&&(o=!1,M(D,H,V,N),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function h(D){return n.deleteVertexArray(D)}function f(D,H,V,N){let W=N.wireframe===!0,K=i[H.id];K===void 0&&(K={},i[H.id]=K);let z=D.isInstancedMesh===!0?D.id:0,ue=K[z];ue===void 0&&(ue={},K[z]=ue);let j=ue[V.id];j===void 0&&(j={},ue[V.id]=j);let ee=j[W];return ee===void 0&&(ee=d(l()),j[W]=ee),ee}function d(D){let H=[],V=[],N=[];for(let W=0;W<t;W++)H[W]=0,V[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:H,enabledAttributes:V,attributeDivisors:N,object:D,attributes:{},index:null}}function p(D,H,V,N){let W=s.attributes,K=H.attributes,z=0,ue=V.getAttributes();for(let j in ue)if(ue[j].location>=0){let se=W[j],fe=K[j];if(fe===void 0&&(j==="instanceMatrix"&&D.instanceMatrix&&(fe=D.instanceMatrix),j==="instanceColor"&&D.instanceColor&&(fe=D.instanceColor)),se===void 0||se.attribute!==fe||fe&&se.data!==fe.data)return!0;z++}return s.attributesNum!==z||s.index!==N}function m(D,H,V,N){let W={},K=H.attributes,z=0,ue=V.getAttributes();for(let j in ue)if(ue[j].location>=0){let se=K[j];se===void 0&&(j==="instanceMatrix"&&D.instanceMatrix&&(se=D.instanceMatrix),j==="instanceColor"&&D.instanceColor&&(se=D.instanceColor));let fe={};fe.attribute=se,se&&se.data&&(fe.data=se.data),W[j]=fe,z++}s.attributes=W,s.attributesNum=z,s.index=N}function x(){let D=s.newAttributes;for(let H=0,V=D.length;H<V;H++)D[H]=0}function _(D){g(D,0)}function g(D,H){let V=s.newAttributes,N=s.enabledAttributes,W=s.attributeDivisors;V[D]=1,N[D]===0&&(n.enableVertexAttribArray(D),N[D]=1),W[D]!==H&&(n.vertexAttribDivisor(D,H),W[D]=H)}function v(){let D=s.newAttributes,H=s.enabledAttributes;for(let V=0,N=H.length;V<N;V++)H[V]!==D[V]&&(n.disableVertexAttribArray(V),H[V]=0)}function E(D,H,V,N,W,K,z){z===!0?n.vertexAttribIPointer(D,H,V,W,K):n.vertexAttribPointer(D,H,V,N,W,K)}function M(D,H,V,N){x();let W=N.attributes,K=V.getAttributes(),z=H.defaultAttributeValues;for(let ue in K){let j=K[ue];if(j.location>=0){let ee=W[ue];if(ee===void 0&&(ue==="instanceMatrix"&&D.instanceMatrix&&(ee=D.instanceMatrix),ue==="instanceColor"&&D.instanceColor&&(ee=D.instanceColor)),ee!==void 0){let se=ee.normalized,fe=ee.itemSize,de=e.get(ee);if(de===void 0)continue;let te=de.buffer,_e=de.type,ve=de.bytesPerElement,Re=_e===n.INT||_e===n.UNSIGNED_INT||ee.gpuType===oh;if(ee.isInterleavedBufferAttribute){let we=ee.data,qe=we.isInterleavedBuffer===!0?we.stride:we.itemSize,ct=ee.offset;if(we.isInstancedInterleavedBuffer||we.isInstancedBufferAttribute){for(let $e=0;$e<j.locationSize;$e++)g(j.location+$e,we.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=we.meshPerAttribute*we.count)}else for(let $e=0;$e<j.locationSize;$e++)_(j.location+$e);n.bindBuffer(n.ARRAY_BUFFER,te);for(let $e=0;$e<j.locationSize;$e++)E(j.location+$e,fe/j.locationSize,_e,se,qe*ve,(ct+fe/j.locationSize*$e)*ve,Re)}else{if(ee.isInstancedBufferAttribute){for(let we=0;we<j.locationSize;we++)g(j.location+we,ee.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=ee.meshPerAttribute*ee.count)}else for(let we=0;we<j.locationSize;we++)_(j.location+we);n.bindBuffer(n.ARRAY_BUFFER,te);for(let we=0;we<j.locationSize;we++)E(j.location+we,fe/j.locationSize,_e,se,fe*ve,fe/j.locationSize*we*ve,Re)}}else if(z!==void 0){let se=z[ue];if(se!==void 0)switch(se.length){case 2:n.vertexAttrib2fv(j.location,se);break;case 3:n.vertexAttrib3fv(j.location,se);break;case 4:n.vertexAttrib4fv(j.location,se);break;default:n.vertexAttrib1fv(j.location,se)}}}}v()}function I(){G();for(let D in i){let H=i[D];for(let V in H){let N=H[V];for(let W in N){let K=N[W];for(let z in K)h(K[z].object),delete K[z];delete N[W]}}delete i[D]}}function C(D){if(i[D.id]===void 0)return;let H=i[D.id];for(let V in H){let N=H[V];for(let W in N){let K=N[W];for(let z in K)h(K[z].object),delete K[z];delete N[W]}}delete i[D.id]}function b(D){for(let H in i){let V=i[H];for(let N in V){let W=V[N];if(W[D.id]===void 0)continue;let K=W[D.id];for(let z in K)h(K[z].object),delete K[z];delete W[D.id]}}}function A(D){for(let H in i){let V=i[H],N=D.isInstancedMesh===!0?D.id:0,W=V[N];if(W!==void 0){for(let K in W){let z=W[K];for(let ue in z)h(z[ue].object),delete z[ue];delete W[K]}delete V[N],Object.keys(V).length===0&&delete i[H]}}}function G(){F(),o=!0,s!==r&&(s=r,c(s.object))}function F(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:G,resetDefaultState:F,dispose:I,releaseStatesOfGeometry:C,releaseStatesOfObject:A,releaseStatesOfProgram:b,initAttributes:x,enableAttribute:_,disableUnusedAttributes:v}}function iR(n,e,t){let i;function r(l){i=l}function s(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),t.update(c,i,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let d=0;for(let p=0;p<h;p++)d+=c[p];t.update(d,i,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function rR(n,e,t,i){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let b=e.get("EXT_texture_filter_anisotropic");r=n.getParameter(b.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(b){return!(b!==zi&&i.convert(b)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(b){let A=b===xr&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(b!==Bi&&b!==Vi&&!A&&i.convert(b)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(b){if(b==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";b="mediump"}return b==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ke("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),_=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),I=n.getParameter(n.MAX_SAMPLES),C=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:f,maxTextures:p,maxVertexTextures:m,maxTextureSize:x,maxCubemapSize:_,maxAttributes:g,maxVertexUniforms:v,maxVaryings:E,maxFragmentUniforms:M,maxSamples:I,samples:C}}function sR(n){let e=this,t=null,i=0,r=!1,s=!1,o=new Ni,a=new ot,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,d){let p=f.length!==0||d||i!==0||r;return r=d,i=f.length,p},this.beginShadows=function(){s=!0,h(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(f,d){t=h(f,d,0)},this.setState=function(f,d,p){let m=f.clippingPlanes,x=f.clipIntersection,_=f.clipShadows,g=n.get(f);if(!r||m===null||m.length===0||s&&!_)s?h(null):c();else{let v=s?0:i,E=v*4,M=g.clippingState||null;l.value=M,M=h(m,d,E,p);for(let I=0;I!==E;++I)M[I]=t[I];g.clippingState=M,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(f,d,p,m){let x=f!==null?f.length:0,_=null;if(x!==0){if(_=l.value,m!==!0||_===null){let g=p+x*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(_===null||_.length<g)&&(_=new Float32Array(g));for(let E=0,M=p;E!==x;++E,M+=4)o.copy(f[E]).applyMatrix4(v,a),o.normal.toArray(_,M),_[M+3]=o.constant}l.value=_,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,_}}var Wl=class extends Ui{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new El(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},r=new ba(5,5,5),s=new Or({name:"CubemapFromEquirect",uniforms:bo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:fi,blending:mo});s.uniforms.tEquirect.value=t;let o=new Jn(r,s),a=t.minFilter;return t.minFilter===as&&(t.minFilter=di),new Ma(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,r);e.setRenderTarget(s)}},Qy=256,oR=3,aR=20,Sv=256,Mv=16,lR=3,cR=new X,uR=new Ct,$h=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ma(1,10,null),this._boxMesh=new Jn(new ba(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,r=100,s={}){let{size:o=256,position:a=cR}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,d=l.autoClearColor,p=l.autoClearDepth,m=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(uR));let _=new Ma(i,r,h);return _.position.copy(a),_.update(l,e),l.autoClear=f,l.autoClearColor=d,l.autoClearDepth=p,l.autoClearStencil=m,e.background=x,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=nv(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=tv(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Qy,Xy(e))}_fromTexture(e,t){e.mapping===_o||e.mapping===Ea?this._setSize(e.image.length===0?Qy:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=ev(e,!1,!1),i=Math.log2(e)-oR;for(let r=0;r<=i;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=ev(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===_o||e.mapping===Ea?(this._cubemapMaterial===null&&(this._cubemapMaterial=nv()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=tv()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=hR(),this._integrationMaterial=dR());let t=this._cubeSize,i=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/Mv);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-lR)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Sv*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=fR());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,i),r.envMap.value=e.texture,this._renderCube(s,0,i)}};function ev(n,e,t){return new Wl(n,{minFilter:as,generateMipmaps:e,type:xr,colorSpace:lo,depthBuffer:t})}function $l(n,e,t){return new Or({name:n,uniforms:e,vertexShader:gt.cube_vert,fragmentShader:t,side:fi,blending:mo,depthTest:!1,depthWrite:!1})}function hR(){return $l("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Sv}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function dR(){return $l("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Mv}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function fR(){return $l("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${aR}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function tv(){return $l("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function nv(){return $l("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function pR(n){let e=new WeakMap,t=new WeakMap,i=null;function r(d,p=!1){return d==null?null:p?o(d):s(d)}function s(d){if(d&&d.isTexture){let p=d.mapping;if(p===ih||p===rh)if(e.has(d)){let m=e.get(d).texture;return a(m,d.mapping)}else{let m=d.image;if(m&&m.height>0){let x=new Wl(m.height);return x.fromEquirectangularTexture(n,d),e.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let p=d.mapping,m=p===ih||p===rh,x=p===_o||p===Ea;if(m||x){let _=t.get(d),g=_!==void 0?_.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new $h(n)),_=m?i.fromEquirectangular(d,_):i.fromCubemap(d,_),_.texture.pmremVersion=d.pmremVersion,t.set(d,_),_.texture;if(_!==void 0)return _.texture;{let v=d.image;return m&&v&&v.height>0||x&&v&&l(v)?(i===null&&(i=new $h(n)),_=m?i.fromEquirectangular(d):i.fromCubemap(d),_.texture.pmremVersion=d.pmremVersion,t.set(d,_),d.addEventListener("dispose",h),_.texture):null}}}return d}function a(d,p){return p===ih?d.mapping=_o:p===rh&&(d.mapping=Ea),d}function l(d){let p=0,m=6;for(let x=0;x<m;x++)d[x]!==void 0&&p++;return p===m}function c(d){let p=d.target;p.removeEventListener("dispose",c);let m=e.get(p);m!==void 0&&(e.delete(p),m.dispose())}function h(d){let p=d.target;p.removeEventListener("dispose",h);let m=t.get(p);m!==void 0&&(t.delete(p),m.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:r,dispose:f}}function mR(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let r=n.getExtension(i);return e[i]=r,r}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let r=t(i);return r===null&&pl("WebGLRenderer: "+i+" extension not supported."),r}}}function gR(n,e,t,i){let r={},s=new WeakMap,o=new FinalizationRegistry(m=>delete r[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let _ in m.attributes)e.remove(m.attributes[_]);m.removeEventListener("dispose",a),delete r[m.id],o.unregister(m);let x=s.get(m);x&&(e.remove(x),s.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,x){return r[x.id]!==void 0||(x.addEventListener("dispose",a),r[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function h(m){let x=m.attributes;for(let _ in x)e.update(x[_],n.ARRAY_BUFFER)}function f(m){let x=m.index,_=m.attributes.position,g=0;if(_===void 0)return;let v=x!==null?x.array.length:_.array.length/3-1,E=_.count>=65535?wl:Ml,M=new E(Math.ceil(v/3)*6,1),I=M.array;if(x!==null){let b=x.array;g=x.version;for(let A=0,G=0;A<v;A+=3){let F=b[A+0],D=b[A+1],H=b[A+2];I[G++]=F,I[G++]=D,I[G++]=D,I[G++]=H,I[G++]=H,I[G++]=F}}else{g=_.version;for(let b=0,A=0;b<v;b+=3){let G=b+0,F=b+1,D=b+2;I[A++]=G,I[A++]=F,I[A++]=F,I[A++]=D,I[A++]=D,I[A++]=G}}M.version=g;let C=s.get(m);C&&e.remove(C),s.set(m,M)}function d(m){let x=s.get(m);if(x){let _=m.index;_!==null&&x.version<_.version&&f(m)}else f(m);return s.get(m)}function p(){for(let m in r){let x=r[m].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:d,dispose:p}}function _R(n,e,t){let i;function r(f){i=f}let s,o;function a(f){s=f.type,o=f.bytesPerElement}function l(f,d){n.drawElements(i,d,s,f*o),t.update(d,i,1)}function c(f,d,p){p!==0&&(n.drawElementsInstanced(i,d,s,f*o,p),t.update(d,i,p))}function h(f,d,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,s,f,0,p);let x=0;for(let _=0;_<p;_++)x+=d[_];t.update(x,i,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function xR(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(s/3);break;case n.LINES:t.lines+=a*(s/2);break;case n.LINE_STRIP:t.lines+=a*(s-1);break;case n.LINE_LOOP:t.lines+=a*s;break;case n.POINTS:t.points+=a*s;break;default:st("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:i}}function yR(n,e,t){let i=new WeakMap,r=new ln;function s(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=h!==void 0?h.length:0,d=i.get(a);if(d===void 0||d.count!==f){let G=function(){b.dispose(),i.delete(a),a.removeEventListener("dispose",G)};d!==void 0&&d.texture.dispose();let p=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,_=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],E=0;p===!0&&(E=1),m===!0&&(E=2),x===!0&&(E=3);let M=a.attributes.position.count*E,I=1;M>e.maxTextureSize&&(I=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);let C=new Float32Array(M*I*4*f),b=new vl(C,M,I,f);b.type=Vi,b.needsUpdate=!0;let A=E*4;for(let F=0;F<f;F++){let D=_[F],H=g[F],V=v[F],N=M*I*4*F;for(let W=0;W<D.count;W++){let K=W*A;p===!0&&(r.fromBufferAttribute(D,W),C[N+K+0]=r.x,C[N+K+1]=r.y,C[N+K+2]=r.z,C[N+K+3]=0),m===!0&&(r.fromBufferAttribute(H,W),C[N+K+4]=r.x,C[N+K+5]=r.y,C[N+K+6]=r.z,C[N+K+7]=0),x===!0&&(r.fromBufferAttribute(V,W),C[N+K+8]=r.x,C[N+K+9]=r.y,C[N+K+10]=r.z,C[N+K+11]=V.itemSize===4?r.w:1)}}d={count:f,texture:b,size:new Et(M,I)},i.set(a,d),a.addEventListener("dispose",G)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let p=0;for(let x=0;x<c.length;x++)p+=c[x];let m=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:s}}function vR(n,e,t,i,r){let s=new WeakMap;function o(c){let h=r.render.frame,f=c.geometry,d=e.get(c,f);if(s.get(d)!==h&&(e.update(d),s.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==h&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),s.set(c,h))),c.isSkinnedMesh){let p=c.skeleton;s.get(p)!==h&&(p.update(),s.set(p,h))}return d}function a(){s=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var bR={[Yp]:"LINEAR_TONE_MAPPING",[Jp]:"REINHARD_TONE_MAPPING",[Zp]:"CINEON_TONE_MAPPING",[Kp]:"ACES_FILMIC_TONE_MAPPING",[Qp]:"AGX_TONE_MAPPING",[em]:"NEUTRAL_TONE_MAPPING",[jp]:"CUSTOM_TONE_MAPPING"};function SR(n,e,t,i,r,s){let o=new Ui(e,t,{type:n,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new tr;h.setAttribute("position",new gi([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new gi([0,2,0,0,2,0],2));let f=new Sa({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Jn(h,f),p=new th(-1,1,1,-1,0,1),m=null,x=null,_=!1,g,v=null,E=[],M=!1;this.setSize=function(I,C){o.setSize(I,C),a!==null&&a.setSize(I,C),l!==null&&l.setSize(I,C);for(let b=0;b<E.length;b++){let A=E[b];A.setSize&&A.setSize(I,C)}},this.setEffects=function(I){E=I,M=E.length>0&&E[0].isRenderPass===!0;let C=o.width,b=o.height;E.length>0&&a===null&&(a=new Ui(C,b,{type:xr,depthBuffer:!1,stencilBuffer:!1}),l=new Ui(C,b,{type:xr,depthBuffer:!1,stencilBuffer:!1}));let A=r===!0&&E.some(G=>G.needsDepthTexture===!0);A!==(o.depthTexture!==null)&&(A===!0&&c===null&&(c=new os(C,b),s===!0&&(c.format=ls,c.type=xo)),o.dispose(),o.depthTexture=A?c:null,o.resolveDepthBuffer=A,o.storeMultisampledDepthBuffer=A);for(let G=0;G<E.length;G++){let F=E[G];F.setSize&&F.setSize(C,b),A&&F.needsDepthTexture===!0&&F.setDepthTexture&&F.setDepthTexture(c)}},this.begin=function(I,C){if(_||I.toneMapping===Br&&E.length===0)return!1;if(v=C,C!==null){let b=C.width,A=C.height;(o.width!==b||o.height!==A)&&this.setSize(b,A)}return M===!1&&I.setRenderTarget(o),g=I.toneMapping,I.toneMapping=Br,!0},this.hasRenderPass=function(){return M},this.end=function(I,C){I.toneMapping=g,_=!0;let b=o,A=a;for(let G=0;G<E.length;G++){let F=E[G];F.enabled!==!1&&(F.render(I,A,b,C),F.needsSwap!==!1&&(b=A,A=A===a?l:a))}if(m!==I.outputColorSpace||x!==I.toneMapping){m=I.outputColorSpace,x=I.toneMapping,f.defines={},bt.getTransfer(m)===kt&&(f.defines.SRGB_TRANSFER="");let G=bR[x];G&&(f.defines[G]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=b.texture,I.setRenderTarget(v),I.render(d,p),v=null,_=!1},this.isCompositing=function(){return _},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),f.dispose()}}var wv=new _i,Tv=new os(1,1),Av=new Cl(1),Ev=new vl,Cv=new Fu,Rv=new El,iv=[],rv=[],sv=new Float32Array(16),ov=new Float32Array(9),av=new Float32Array(4);function Pa(n,e,t){let i=n[0];if(i<=0||i>0)return n;let r=e*t,s=iv[r];if(s===void 0&&(s=new Float32Array(r),iv[r]=s),e!==0){i.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(s,a)}return s}function Fn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Un(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function qh(n,e){let t=rv[e];t===void 0&&(t=new Int32Array(e),rv[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function MR(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function wR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Fn(t,e))return;n.uniform2fv(this.addr,e),Un(t,e)}}function TR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Fn(t,e))return;n.uniform3fv(this.addr,e),Un(t,e)}}function AR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Fn(t,e))return;n.uniform4fv(this.addr,e),Un(t,e)}}function ER(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Fn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Un(t,e)}else{if(Fn(t,i))return;av.set(i),n.uniformMatrix2fv(this.addr,!1,av),Un(t,i)}}function CR(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Fn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Un(t,e)}else{if(Fn(t,i))return;ov.set(i),n.uniformMatrix3fv(this.addr,!1,ov),Un(t,i)}}function RR(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Fn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Un(t,e)}else{if(Fn(t,i))return;sv.set(i),n.uniformMatrix4fv(this.addr,!1,sv),Un(t,i)}}function PR(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function IR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Fn(t,e))return;n.uniform2iv(this.addr,e),Un(t,e)}}function LR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Fn(t,e))return;n.uniform3iv(this.addr,e),Un(t,e)}}function DR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Fn(t,e))return;n.uniform4iv(this.addr,e),Un(t,e)}}function NR(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function FR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Fn(t,e))return;n.uniform2uiv(this.addr,e),Un(t,e)}}function UR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Fn(t,e))return;n.uniform3uiv(this.addr,e),Un(t,e)}}function kR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Fn(t,e))return;n.uniform4uiv(this.addr,e),Un(t,e)}}function Yh(n){return n.version===0&&(n.compareFunction=dm,n.needsUpdate=!0),n}function OR(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_2D_SHADOW?s=Yh(Tv):s=wv,t.setTexture2D(e||s,r)}function BR(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture3D(e||Cv,r)}function VR(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_CUBE_SHADOW?s=Yh(Av):s=Rv,t.setTextureCube(e||s,r)}function zR(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture2DArray(e||Ev,r)}function HR(n){switch(n){case 5126:return MR;case 35664:return wR;case 35665:return TR;case 35666:return AR;case 35674:return ER;case 35675:return CR;case 35676:return RR;case 5124:case 35670:return PR;case 35667:case 35671:return IR;case 35668:case 35672:return LR;case 35669:case 35673:return DR;case 5125:return NR;case 36294:return FR;case 36295:return UR;case 36296:return kR;case 35678:case 36198:case 36298:case 36306:case 35682:return OR;case 35679:case 36299:case 36307:return BR;case 35680:case 36300:case 36308:case 36293:return VR;case 36289:case 36303:case 36311:case 36292:return zR}}function GR(n,e){n.uniform1fv(this.addr,e)}function WR(n,e){let t=Pa(e,this.size,2);n.uniform2fv(this.addr,t)}function $R(n,e){let t=Pa(e,this.size,3);n.uniform3fv(this.addr,t)}function XR(n,e){let t=Pa(e,this.size,4);n.uniform4fv(this.addr,t)}function qR(n,e){let t=Pa(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function YR(n,e){let t=Pa(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function JR(n,e){let t=Pa(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function ZR(n,e){n.uniform1iv(this.addr,e)}function KR(n,e){n.uniform2iv(this.addr,e)}function jR(n,e){n.uniform3iv(this.addr,e)}function QR(n,e){n.uniform4iv(this.addr,e)}function eP(n,e){n.uniform1uiv(this.addr,e)}function tP(n,e){n.uniform2uiv(this.addr,e)}function nP(n,e){n.uniform3uiv(this.addr,e)}function iP(n,e){n.uniform4uiv(this.addr,e)}function rP(n,e,t){let i=this.cache,r=e.length,s=qh(t,r);Fn(i,s)||(n.uniform1iv(this.addr,s),Un(i,s));let o;this.type===n.SAMPLER_2D_SHADOW?o=Yh(Tv):o=wv;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function sP(n,e,t){let i=this.cache,r=e.length,s=qh(t,r);Fn(i,s)||(n.uniform1iv(this.addr,s),Un(i,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||Cv,s[o])}function oP(n,e,t){let i=this.cache,r=e.length,s=qh(t,r);Fn(i,s)||(n.uniform1iv(this.addr,s),Un(i,s));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Yh(Av):o=Rv;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function aP(n,e,t){let i=this.cache,r=e.length,s=qh(t,r);Fn(i,s)||(n.uniform1iv(this.addr,s),Un(i,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||Ev,s[o])}function lP(n){switch(n){case 5126:return GR;case 35664:return WR;case 35665:return $R;case 35666:return XR;case 35674:return qR;case 35675:return YR;case 35676:return JR;case 5124:case 35670:return ZR;case 35667:case 35671:return KR;case 35668:case 35672:return jR;case 35669:case 35673:return QR;case 5125:return eP;case 36294:return tP;case 36295:return nP;case 36296:return iP;case 35678:case 36198:case 36298:case 36306:case 35682:return rP;case 35679:case 36299:case 36307:return sP;case 35680:case 36300:case 36308:case 36293:return oP;case 36289:case 36303:case 36311:case 36292:return aP}}var vm=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=HR(t.type)}},bm=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=lP(t.type)}},Sm=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],i)}}},xm=/(\w+)(\])?(\[|\.)?/g;function lv(n,e){n.seq.push(e),n.map[e.id]=e}function cP(n,e,t){let i=n.name,r=i.length;for(xm.lastIndex=0;;){let s=xm.exec(i),o=xm.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){lv(t,c===void 0?new vm(a,n,e):new bm(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new Sm(a),lv(t,f)),t=f}}}var Ra=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);cP(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,i,r){let s=this.map[t];s!==void 0&&s.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&i.push(o)}return i}};function cv(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var uP=37297,hP=0;function dP(n,e){let t=n.split(`
`),i=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var uv=new ot;function fP(n){bt._getMatrix(uv,bt.workingColorSpace,n);let e=`mat3( ${uv.elements.map(t=>t.toFixed(4))} )`;switch(bt.getTransfer(n)){case gl:return[e,"LinearTransferOETF"];case kt:return[e,"sRGBTransferOETF"];default:return Ke("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function hv(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+dP(n.getShaderSource(e),a)}else return s}function pP(n,e){let t=fP(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var mP={[Yp]:"Linear",[Jp]:"Reinhard",[Zp]:"Cineon",[Kp]:"ACESFilmic",[Qp]:"AgX",[em]:"Neutral",[jp]:"Custom"};function gP(n,e){let t=mP[e];return t===void 0?(Ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Wh=new X;function _P(){bt.getLuminanceCoefficients(Wh);let n=Wh.x.toFixed(4),e=Wh.y.toFixed(4),t=Wh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function xP(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Gl).join(`
`)}function yP(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function vP(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=n.getActiveAttrib(e,r),o=s.name,a=1;s.type===n.FLOAT_MAT2&&(a=2),s.type===n.FLOAT_MAT3&&(a=3),s.type===n.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Gl(n){return n!==""}function dv(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function fv(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var bP=/^[ \t]*#include +<([\w\d./]+)>/gm;function Mm(n){return n.replace(bP,SP)}function SP(n,e){let t=gt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Mm(t)}var MP=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function pv(n){return n.replace(MP,wP)}function wP(n,e,t,i){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function mv(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var TP={[Dl]:"SHADOWMAP_TYPE_PCF",[Ta]:"SHADOWMAP_TYPE_VSM"};function AP(n){return TP[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var EP={[Ea]:"ENVMAP_MODE_REFRACTION"};function CP(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":EP[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var RP={[qp]:"ENVMAP_BLENDING_MULTIPLY",[Iy]:"ENVMAP_BLENDING_MIX",[Ly]:"ENVMAP_BLENDING_ADD"};function PP(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":RP[n.combine]||"ENVMAP_BLENDING_NONE"}function IP(n,e,t,i){let r=n.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,l=AP(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=CP(t),f=PP(t),d=xP(t),p=yP(s),m=r.createProgram(),x,_,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Gl).join(`
`),x.length>0&&(x+=`
`),_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(Gl).join(`
`),_.length>0&&(_+=`
`)):(x=[mv(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Gl).join(`
`),_=[mv(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Br?"#define TONE_MAPPING":"",t.toneMapping!==Br?gt.tonemapping_pars_fragment:"",t.toneMapping!==Br?gP("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",gt.colorspace_pars_fragment,pP("linearToOutputTexel",t.outputColorSpace),_P(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Gl).join(`
`)),o=Mm(o),o=dv(o,t),o=fv(o,t),a=Mm(a),a=dv(a,t),a=fv(a,t),o=pv(o),a=pv(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,_=["#define varying in",t.glslVersion===zl?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===zl?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+_);let v=g+x+o,E=g+_+a,M=cv(r,r.VERTEX_SHADER,v),I=cv(r,r.FRAGMENT_SHADER,E);r.attachShader(m,M),r.attachShader(m,I),t.index0AttributeName!==void 0?r.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(m,0,"position"),r.linkProgram(m);function C(F){if(n.debug.checkShaderErrors){let D=r.getProgramInfoLog(m)||"",H=r.getShaderInfoLog(M)||"",V=r.getShaderInfoLog(I)||"",N=D.trim(),W=H.trim(),K=V.trim(),z=!0,ue=!0;if(r.getProgramParameter(m,r.LINK_STATUS)===!1)if(z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(r,m,M,I);else{let j=hv(r,M,"vertex"),ee=hv(r,I,"fragment");st("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(m,r.VALIDATE_STATUS)+`

Material Name: `+F.name+`
Material Type: `+F.type+`

Program Info Log: `+N+`
`+j+`
`+ee)}else N!==""?Ke("WebGLProgram: Program Info Log:",N):(W===""||K==="")&&(ue=!1);ue&&(F.diagnostics={runnable:z,programLog:N,vertexShader:{log:W,prefix:x},fragmentShader:{log:K,prefix:_}})}r.deleteShader(M),r.deleteShader(I),b=new Ra(r,m),A=vP(r,m)}let b;this.getUniforms=function(){return b===void 0&&C(this),b};let A;this.getAttributes=function(){return A===void 0&&C(this),A};let G=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return G===!1&&(G=r.getProgramParameter(m,uP)),G},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=hP++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=M,this.fragmentShader=I,this}var LP=0,wm=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Tm(e),t.set(e,i)),i}},Tm=class{constructor(e){this.id=LP++,this.code=e,this.usedTimes=0}};function DP(n){return n===Gs||n===Bl||n===Vl}function NP(n,e,t,i,r,s){let o=new bl,a=new wm,l=new Set,c=[],h=new Map,f=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(b){return l.add(b),b===0?"uv":`uv${b}`}function m(b,A,G,F,D,H){let V=F.fog,N=D.geometry,W=b.isMeshStandardMaterial||b.isMeshLambertMaterial||b.isMeshPhongMaterial?F.environment:null,K=b.isMeshStandardMaterial||b.isMeshLambertMaterial&&!b.envMap||b.isMeshPhongMaterial&&!b.envMap,z=e.get(b.envMap||W,K),ue=d[b.type],j=i.precision;b.precision!==null&&(j=i.getMaxPrecision(b.precision),j!==b.precision&&Ke("WebGLProgram.getParameters:",b.precision,"not supported, using",j,"instead."));let ee=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,se=ee!==void 0?ee.length:0,fe=0;N.morphAttributes.position!==void 0&&(fe=1),N.morphAttributes.normal!==void 0&&(fe=2),N.morphAttributes.color!==void 0&&(fe=3);let de,te,_e,ve;if(ue){let Pe=zr[ue];de=Pe.vertexShader,te=Pe.fragmentShader}else{de=b.vertexShader,te=b.fragmentShader;let Pe=a.getVertexShaderStage(b),ht=a.getFragmentShaderStage(b);a.update(b,Pe,ht),_e=Pe.id,ve=ht.id}let Re=n.getRenderTarget(),we=n.state.buffers.depth.getReversed(),qe=D.isInstancedMesh===!0,ct=D.isBatchedMesh===!0,$e=!!b.map,_t=!!b.matcap,ft=!!z,at=ft&&z.isPMREMTexture===!0,rn=!!b.aoMap,Yt=!!b.lightMap,yn=!!b.bumpMap&&b.wireframe===!1,Gt=!!b.normalMap,On=!!b.displacementMap,At=!!b.emissiveMap,Pn=!!b.metalnessMap,cn=!!b.roughnessMap,vn=b.anisotropy>0,k=b.clearcoat>0,Ie=b.diffuseRoughness>0,Ze=b.dispersion>0,ut=b.retroreflectivity>0,Te=b.iridescence>0,$t=b.sheen>0,We=b.transmission>0,Je=vn&&!!b.anisotropyMap,R=k&&!!b.clearcoatMap,S=k&&!!b.clearcoatNormalMap,$=k&&!!b.clearcoatRoughnessMap,he=Ie&&!!b.diffuseRoughnessMap,ae=Te&&!!b.iridescenceMap,ye=Te&&!!b.iridescenceThicknessMap,be=$t&&!!b.sheenColorMap,ne=$t&&!!b.sheenRoughnessMap,re=!!b.specularMap,me=!!b.specularColorMap,U=!!b.specularIntensityMap,oe=We&&!!b.transmissionMap,ie=We&&!!b.thicknessMap,Ae=!!b.gradientMap,xe=!!b.alphaMap,Me=b.alphaTest>0,Xe=!!b.alphaHash,tt=!!b.extensions,ce=Br;b.toneMapped&&(Re===null||Re.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ze=at?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,nt={shaderID:ue,shaderType:b.type,shaderName:b.name,vertexShader:de,fragmentShader:te,defines:b.defines,customVertexShaderID:_e,customFragmentShaderID:ve,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:j,batching:ct,batchingColor:ct&&D._colorsTexture!==null,instancing:qe,instancingColor:qe&&D.instanceColor!==null,instancingMorph:qe&&D.morphTexture!==null,outputColorSpace:Re===null?n.outputColorSpace:Re.isXRRenderTarget===!0?Re.texture.colorSpace:bt.workingColorSpace,alphaToCoverage:!!b.alphaToCoverage,map:$e,matcap:_t,envMap:ft,envMapMode:ft&&z.mapping,envMapPMREM:at,envMapMaxLod:at?ze.length-1:null,envMapSize:at?ze[0].width:null,aoMap:rn,lightMap:Yt,bumpMap:yn,normalMap:Gt,displacementMap:On,emissiveMap:At,normalMapObjectSpace:Gt&&b.normalMapType===Fy,normalMapTangentSpace:Gt&&b.normalMapType===cm,packedNormalMap:Gt&&b.normalMapType===cm&&DP(b.normalMap.format),metalnessMap:Pn,roughnessMap:cn,anisotropy:vn,anisotropyMap:Je,clearcoat:k,clearcoatMap:R,clearcoatNormalMap:S,clearcoatRoughnessMap:$,diffuseRoughness:Ie,diffuseRoughnessMap:he,dispersion:Ze,retroreflection:ut,iridescence:Te,iridescenceMap:ae,iridescenceThicknessMap:ye,sheen:$t,sheenColorMap:be,sheenRoughnessMap:ne,specularMap:re,specularColorMap:me,specularIntensityMap:U,transmission:We,transmissionMap:oe,thicknessMap:ie,gradientMap:Ae,opaque:b.transparent===!1&&b.blending===Aa&&b.alphaToCoverage===!1,alphaMap:xe,alphaTest:Me,alphaHash:Xe,combine:b.combine,mapUv:$e&&p(b.map.channel),aoMapUv:rn&&p(b.aoMap.channel),lightMapUv:Yt&&p(b.lightMap.channel),bumpMapUv:yn&&p(b.bumpMap.channel),normalMapUv:Gt&&p(b.normalMap.channel),displacementMapUv:On&&p(b.displacementMap.channel),emissiveMapUv:At&&p(b.emissiveMap.channel),metalnessMapUv:Pn&&p(b.metalnessMap.channel),roughnessMapUv:cn&&p(b.roughnessMap.channel),anisotropyMapUv:Je&&p(b.anisotropyMap.channel),clearcoatMapUv:R&&p(b.clearcoatMap.channel),clearcoatNormalMapUv:S&&p(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&p(b.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&p(b.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&p(b.iridescenceMap.channel),iridescenceThicknessMapUv:ye&&p(b.iridescenceThicknessMap.channel),sheenColorMapUv:be&&p(b.sheenColorMap.channel),sheenRoughnessMapUv:ne&&p(b.sheenRoughnessMap.channel),specularMapUv:re&&p(b.specularMap.channel),specularColorMapUv:me&&p(b.specularColorMap.channel),specularIntensityMapUv:U&&p(b.specularIntensityMap.channel),transmissionMapUv:oe&&p(b.transmissionMap.channel),thicknessMapUv:ie&&p(b.thicknessMap.channel),alphaMapUv:xe&&p(b.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Gt||vn),vertexNormals:!!N.attributes.normal,vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!N.attributes.uv&&($e||xe),fog:!!V,useFog:b.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:b.wireframe===!1&&(b.flatShading===!0||N.attributes.normal===void 0&&Gt===!1&&(b.isMeshLambertMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isMeshPhysicalMaterial)),sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:we,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:se,morphTextureStride:fe,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:H.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:b.dithering,shadowMapEnabled:n.shadowMap.enabled&&G.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:$e&&b.map.isVideoTexture===!0&&bt.getTransfer(b.map.colorSpace)===kt,decodeVideoTextureEmissive:At&&b.emissiveMap.isVideoTexture===!0&&bt.getTransfer(b.emissiveMap.colorSpace)===kt,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===nr,flipSided:b.side===fi,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:tt&&b.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(tt&&b.extensions.multiDraw===!0||ct)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return nt.vertexUv1s=l.has(1),nt.vertexUv2s=l.has(2),nt.vertexUv3s=l.has(3),l.clear(),nt}function x(b){let A=[];if(b.shaderID?A.push(b.shaderID):(A.push(b.customVertexShaderID),A.push(b.customFragmentShaderID)),b.defines!==void 0)for(let G in b.defines)A.push(G),A.push(b.defines[G]);return b.isRawShaderMaterial===!1&&(_(A,b),g(A,b),A.push(n.outputColorSpace)),A.push(b.customProgramCacheKey),A.join()}function _(b,A){b.push(A.precision),b.push(A.outputColorSpace),b.push(A.envMapMode),b.push(A.envMapPMREM),b.push(A.envMapMaxLod),b.push(A.envMapSize),b.push(A.mapUv),b.push(A.alphaMapUv),b.push(A.lightMapUv),b.push(A.aoMapUv),b.push(A.bumpMapUv),b.push(A.normalMapUv),b.push(A.displacementMapUv),b.push(A.emissiveMapUv),b.push(A.metalnessMapUv),b.push(A.roughnessMapUv),b.push(A.anisotropyMapUv),b.push(A.clearcoatMapUv),b.push(A.clearcoatNormalMapUv),b.push(A.clearcoatRoughnessMapUv),b.push(A.diffuseRoughnessMapUv),b.push(A.iridescenceMapUv),b.push(A.iridescenceThicknessMapUv),b.push(A.sheenColorMapUv),b.push(A.sheenRoughnessMapUv),b.push(A.specularMapUv),b.push(A.specularColorMapUv),b.push(A.specularIntensityMapUv),b.push(A.transmissionMapUv),b.push(A.thicknessMapUv),b.push(A.combine),b.push(A.fogExp2),b.push(A.sizeAttenuation),b.push(A.morphTargetsCount),b.push(A.numSunLights),b.push(A.numDirLights),b.push(A.numPointLights),b.push(A.numSpotLights),b.push(A.numSpotLightMaps),b.push(A.numHemiLights),b.push(A.numRectAreaLights),b.push(A.numSunLightShadows),b.push(A.numDirLightShadows),b.push(A.numPointLightShadows),b.push(A.numSpotLightShadows),b.push(A.numSpotLightShadowsWithMaps),b.push(A.numLightProbes),b.push(A.numLightProbeGrids),b.push(A.shadowMapType),b.push(A.toneMapping),b.push(A.numClippingPlanes),b.push(A.numClipIntersection),b.push(A.depthPacking)}function g(b,A){o.disableAll(),A.instancing&&o.enable(0),A.instancingColor&&o.enable(1),A.instancingMorph&&o.enable(2),A.matcap&&o.enable(3),A.envMap&&o.enable(4),A.normalMapObjectSpace&&o.enable(5),A.normalMapTangentSpace&&o.enable(6),A.clearcoat&&o.enable(7),A.iridescence&&o.enable(8),A.alphaTest&&o.enable(9),A.vertexColors&&o.enable(10),A.vertexAlphas&&o.enable(11),A.vertexUv1s&&o.enable(12),A.vertexUv2s&&o.enable(13),A.vertexUv3s&&o.enable(14),A.vertexTangents&&o.enable(15),A.anisotropy&&o.enable(16),A.alphaHash&&o.enable(17),A.batching&&o.enable(18),A.dispersion&&o.enable(19),A.retroreflection&&o.enable(24),A.diffuseRoughness&&o.enable(25),A.batchingColor&&o.enable(20),A.gradientMap&&o.enable(21),A.packedNormalMap&&o.enable(22),A.vertexNormals&&o.enable(23),b.push(o.mask),o.disableAll(),A.fog&&o.enable(0),A.useFog&&o.enable(1),A.flatShading&&o.enable(2),A.logarithmicDepthBuffer&&o.enable(3),A.reversedDepthBuffer&&o.enable(4),A.skinning&&o.enable(5),A.morphTargets&&o.enable(6),A.morphNormals&&o.enable(7),A.morphColors&&o.enable(8),A.premultipliedAlpha&&o.enable(9),A.shadowMapEnabled&&o.enable(10),A.doubleSided&&o.enable(11),A.flipSided&&o.enable(12),A.useDepthPacking&&o.enable(13),A.dithering&&o.enable(14),A.transmission&&o.enable(15),A.sheen&&o.enable(16),A.opaque&&o.enable(17),A.pointsUvs&&o.enable(18),A.decodeVideoTexture&&o.enable(19),A.decodeVideoTextureEmissive&&o.enable(20),A.alphaToCoverage&&o.enable(21),A.numLightProbeGrids>0&&o.enable(22),A.hasPositionAttribute&&o.enable(23),b.push(o.mask)}function v(b){let A=d[b.type],G;if(A){let F=zr[A];G=Zy.clone(F.uniforms)}else G=b.uniforms;return G}function E(b,A){let G=h.get(A);return G!==void 0?++G.usedTimes:(G=new IP(n,A,b,r),c.push(G),h.set(A,G)),G}function M(b){if(--b.usedTimes===0){let A=c.indexOf(b);c[A]=c[c.length-1],c.pop(),h.delete(b.cacheKey),b.destroy()}}function I(b){a.remove(b)}function C(){a.dispose()}return{getParameters:m,getProgramCacheKey:x,getUniforms:v,acquireProgram:E,releaseProgram:M,releaseShaderCache:I,programs:c,dispose:C}}function FP(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function r(o,a,l){n.get(o)[a]=l}function s(){n=new WeakMap}return{has:e,get:t,remove:i,update:r,dispose:s}}function UP(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function gv(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function _v(){let n=[],e=0,t=[],i=[],r=[];function s(){e=0,t.length=0,i.length=0,r.length=0}function o(d){let p=0;return d.isInstancedMesh&&(p+=2),d.isSkinnedMesh&&(p+=1),p}function a(d,p,m,x,_,g){let v=n[e];return v===void 0?(v={id:d.id,object:d,geometry:p,material:m,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:_,group:g},n[e]=v):(v.id=d.id,v.object=d,v.geometry=p,v.material=m,v.materialVariant=o(d),v.groupOrder=x,v.renderOrder=d.renderOrder,v.z=_,v.group=g),e++,v}function l(d,p,m,x,_,g,v){v.reversedDepth===!0&&(_=-_);let E=a(d,p,m,x,_,g);m.transmission>0?i.push(E):m.transparent===!0?r.push(E):t.push(E)}function c(d,p,m,x,_,g){let v=a(d,p,m,x,_,g);m.transmission>0?i.unshift(v):m.transparent===!0?r.unshift(v):t.unshift(v)}function h(d,p){t.length>1&&t.sort(d||UP),i.length>1&&i.sort(p||gv),r.length>1&&r.sort(p||gv)}function f(){for(let d=e,p=n.length;d<p;d++){let m=n[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:i,transparent:r,init:s,push:l,unshift:c,finish:f,sort:h}}function kP(){let n=new WeakMap;function e(i,r){let s=n.get(i),o;return s===void 0?(o=new _v,n.set(i,[o])):r>=s.length?(o=new _v,s.push(o)):o=s[r],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function OP(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new X,color:new Ct};break;case"SpotLight":t={position:new X,direction:new X,color:new Ct,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new X,color:new Ct,distance:0,decay:0};break;case"HemisphereLight":t={direction:new X,skyColor:new Ct,groundColor:new Ct};break;case"RectAreaLight":t={color:new Ct,position:new X,halfWidth:new X,halfHeight:new X};break}return n[e.id]=t,t}}}function BP(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Et};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Et};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Et,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var VP=0;function zP(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function HP(n){let e=new OP,t=BP(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new X);let r=new X,s=new Zt,o=new Zt;function a(c){let h=0,f=0,d=0;for(let H=0;H<9;H++)i.probe[H].set(0,0,0);let p=0,m=0,x=0,_=0,g=0,v=0,E=0,M=0,I=0,C=0,b=0,A=0,G=0,F=0;c.sort(zP);for(let H=0,V=c.length;H<V;H++){let N=c[H],W=N.color,K=N.intensity,z=N.distance,ue=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Gs?ue=N.shadow.map.texture:ue=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)h+=W.r*K,f+=W.g*K,d+=W.b*K;else if(N.isLightProbe){for(let j=0;j<9;j++)i.probe[j].addScaledVector(N.sh.coefficients[j],K);F++}else if(N.isSunLight){let j=e.get(N);if(j.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let ee=N.shadow,se=t.get(N);se.shadowIntensity=ee.intensity,se.shadowBias=ee.bias,se.shadowNormalBias=ee.normalBias,se.shadowRadius=ee.radius,se.shadowMapSize.copy(ee.mapSize).multiply(ee.getFrameExtents()),i.sunShadow[m]=se,i.sunShadowMap[m]=ue;let fe=ee.getViewportCount();for(let de=0;de<fe;de++)i.sunShadowMatrix[x+de]=ee.getMatrix(de),i.sunShadowCascade[x+de]=ee._cascadeData[de];x+=fe,m++}i.sun[p]=j,p++}else if(N.isDirectionalLight){let j=e.get(N);if(j.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let ee=N.shadow,se=t.get(N);se.shadowIntensity=ee.intensity,se.shadowBias=ee.bias,se.shadowNormalBias=ee.normalBias,se.shadowRadius=ee.radius,se.shadowMapSize=ee.mapSize,i.directionalShadow[_]=se,i.directionalShadowMap[_]=ue,i.directionalShadowMatrix[_]=N.shadow.matrix,I++}i.directional[_]=j,_++}else if(N.isSpotLight){let j=e.get(N);j.position.setFromMatrixPosition(N.matrixWorld),j.color.copy(W).multiplyScalar(K),j.distance=z,j.coneCos=Math.cos(N.angle),j.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),j.decay=N.decay,i.spot[v]=j;let ee=N.shadow;if(N.map&&(i.spotLightMap[A]=N.map,A++,ee.updateMatrices(N),N.castShadow&&G++),i.spotLightMatrix[v]=ee.matrix,N.castShadow){let se=t.get(N);se.shadowIntensity=ee.intensity,se.shadowBias=ee.bias,se.shadowNormalBias=ee.normalBias,se.shadowRadius=ee.radius,se.shadowMapSize=ee.mapSize,i.spotShadow[v]=se,i.spotShadowMap[v]=ue,b++}v++}else if(N.isRectAreaLight){let j=e.get(N);j.color.copy(W).multiplyScalar(K),j.halfWidth.set(N.width*.5,0,0),j.halfHeight.set(0,N.height*.5,0),i.rectArea[E]=j,E++}else if(N.isPointLight){let j=e.get(N);if(j.color.copy(N.color).multiplyScalar(N.intensity),j.distance=N.distance,j.decay=N.decay,N.castShadow){let ee=N.shadow,se=t.get(N);se.shadowIntensity=ee.intensity,se.shadowBias=ee.bias,se.shadowNormalBias=ee.normalBias,se.shadowRadius=ee.radius,se.shadowMapSize=ee.mapSize,se.shadowCameraNear=ee.camera.near,se.shadowCameraFar=ee.camera.far,i.pointShadow[g]=se,i.pointShadowMap[g]=ue,i.pointShadowMatrix[g]=N.shadow.matrix,C++}i.point[g]=j,g++}else if(N.isHemisphereLight){let j=e.get(N);j.skyColor.copy(N.color).multiplyScalar(K),j.groundColor.copy(N.groundColor).multiplyScalar(K),i.hemi[M]=j,M++}}E>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ne.LTC_FLOAT_1,i.rectAreaLTC2=Ne.LTC_FLOAT_2):(i.rectAreaLTC1=Ne.LTC_HALF_1,i.rectAreaLTC2=Ne.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=f,i.ambient[2]=d;let D=i.hash;(D.sunLength!==p||D.directionalLength!==_||D.pointLength!==g||D.spotLength!==v||D.rectAreaLength!==E||D.hemiLength!==M||D.numSunShadows!==m||D.numDirectionalShadows!==I||D.numPointShadows!==C||D.numSpotShadows!==b||D.numSpotMaps!==A||D.numLightProbes!==F)&&(i.sun.length=p,i.directional.length=_,i.spot.length=v,i.rectArea.length=E,i.point.length=g,i.hemi.length=M,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=I,i.directionalShadowMap.length=I,i.directionalShadowMatrix.length=I,i.pointShadow.length=C,i.pointShadowMap.length=C,i.pointShadowMatrix.length=C,i.spotShadow.length=b,i.spotShadowMap.length=b,i.spotLightMatrix.length=b+A-G,i.spotLightMap.length=A,i.numSpotLightShadowsWithMaps=G,i.numLightProbes=F,D.sunLength=p,D.directionalLength=_,D.pointLength=g,D.spotLength=v,D.rectAreaLength=E,D.hemiLength=M,D.numSunShadows=m,D.numDirectionalShadows=I,D.numPointShadows=C,D.numSpotShadows=b,D.numSpotMaps=A,D.numLightProbes=F,i.version=VP++)}function l(c,h){let f=0,d=0,p=0,m=0,x=0,_=0,g=h.matrixWorldInverse;for(let v=0,E=c.length;v<E;v++){let M=c[v];if(M.isSunLight){let I=i.sun[f];I.direction.setFromMatrixPosition(M.matrixWorld),I.direction.transformDirection(g),f++}else if(M.isDirectionalLight){let I=i.directional[d];I.direction.setFromMatrixPosition(M.matrixWorld),r.setFromMatrixPosition(M.target.matrixWorld),I.direction.sub(r),I.direction.transformDirection(g),d++}else if(M.isSpotLight){let I=i.spot[m];I.position.setFromMatrixPosition(M.matrixWorld),I.position.applyMatrix4(g),I.direction.setFromMatrixPosition(M.matrixWorld),r.setFromMatrixPosition(M.target.matrixWorld),I.direction.sub(r),I.direction.transformDirection(g),m++}else if(M.isRectAreaLight){let I=i.rectArea[x];I.position.setFromMatrixPosition(M.matrixWorld),I.position.applyMatrix4(g),o.identity(),s.copy(M.matrixWorld),s.premultiply(g),o.extractRotation(s),I.halfWidth.set(M.width*.5,0,0),I.halfHeight.set(0,M.height*.5,0),I.halfWidth.applyMatrix4(o),I.halfHeight.applyMatrix4(o),x++}else if(M.isPointLight){let I=i.point[p];I.position.setFromMatrixPosition(M.matrixWorld),I.position.applyMatrix4(g),p++}else if(M.isHemisphereLight){let I=i.hemi[_];I.direction.setFromMatrixPosition(M.matrixWorld),I.direction.transformDirection(g),_++}}}return{setup:a,setupView:l,state:i}}function xv(n){let e=new HP(n),t=[],i=[],r=[];function s(f){h.camera=f,t.length=0,i.length=0,r.length=0}function o(f){f.isLightProbeGrid?r.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),r.sort((f,d)=>f.priority-d.priority||f.id-d.id)}function c(f){e.setupView(t,f)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function GP(n){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new xv(n),e.set(r,[a])):s>=o.length?(a=new xv(n),o.push(a)):a=o[s],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var WP=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,$P=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,XP=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],qP=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],yv=new Zt,Hl=new X,ym=new X;function YP(n,e,t){let i=new ho,r=new Et,s=new Et,o=new ln,a=new Gu,l=new Wu,c={},h=t.maxTextureSize,f={[Hs]:fi,[fi]:Hs,[nr]:nr},d=new Or({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Et},radius:{value:4}},vertexShader:WP,fragmentShader:$P}),p=d.clone();p.defines.HORIZONTAL_PASS=1;let m=new tr;m.setAttribute("position",new pn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Jn(m,d),_=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Dl;let g=this.type;this.render=function(C,b,A){if(_.enabled===!1||_.autoUpdate===!1&&_.needsUpdate===!1||C.length===0)return;this.type===dy&&(Ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Dl);let G=n.getRenderTarget(),F=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),H=n.state;H.setBlending(mo),H.buffers.depth.getReversed()===!0?H.buffers.color.setClear(0,0,0,0):H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);let V=g!==this.type;V&&b.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=C.length;N<W;N++){let K=C[N],z=K.shadow;if(z===void 0){Ke("WebGLShadowMap:",K,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;r.copy(z.mapSize);let ue=z.getFrameExtents();r.multiply(ue),s.copy(z.mapSize),(r.x>h||r.y>h)&&(r.x>h&&(s.x=Math.floor(h/ue.x),r.x=s.x*ue.x,z.mapSize.x=s.x),r.y>h&&(s.y=Math.floor(h/ue.y),r.y=s.y*ue.y,z.mapSize.y=s.y));let j=n.state.buffers.depth.getReversed();if(z.camera._reversedDepth=j,z.map===null||V===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===Ta){if(K.isPointLight){Ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new Ui(r.x,r.y,{format:Gs,type:xr,minFilter:di,magFilter:di,generateMipmaps:!1}),z.map.texture.name=K.name+".shadowMap",z.map.depthTexture=new os(r.x,r.y,Vi),z.map.depthTexture.name=K.name+".shadowMapDepth",z.map.depthTexture.format=ss,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Xn,z.map.depthTexture.magFilter=Xn}else K.isPointLight?(z.map=new Wl(r.x),z.map.depthTexture=new Cl(r.x,_r)):(z.map=new Ui(r.x,r.y),z.map.depthTexture=new os(r.x,r.y,_r)),z.map.depthTexture.name=K.name+".shadowMap",z.map.depthTexture.format=ss,this.type===Dl?(z.map.depthTexture.compareFunction=j?hm:um,z.map.depthTexture.minFilter=di,z.map.depthTexture.magFilter=di):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Xn,z.map.depthTexture.magFilter=Xn);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==r.x||z.map.height!==r.y)&&z.map.setSize(r.x,r.y);let ee=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();K.isPointLight!==!0&&z.updateMatrices(K,A);let se=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:A.layers;for(let fe=0;fe<ee;fe++){let de=z.getCamera(fe);if(K.isPointLight){let te=z.camera,_e=z.matrix,ve=K.distance||te.far;ve!==te.far&&(te.far=ve,te.updateProjectionMatrix()),Hl.setFromMatrixPosition(K.matrixWorld),te.position.copy(Hl),ym.copy(te.position),ym.add(XP[fe]),te.up.copy(qP[fe]),te.lookAt(ym),te.updateMatrixWorld(),_e.makeTranslation(-Hl.x,-Hl.y,-Hl.z),yv.multiplyMatrices(te.projectionMatrix,te.matrixWorldInverse),z._frustum.setFromProjectionMatrix(yv,te.coordinateSystem,te.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)n.setRenderTarget(z.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(z.map),n.clear());let te=z.getViewport(fe);o.set(s.x*te.x,s.y*te.y,s.x*te.z,s.y*te.w),H.viewport(o)}i=z.getFrustum(fe),M(b,A,de,K,se,this.type)}z.isPointLightShadow!==!0&&this.type===Ta&&v(z,A),z.needsUpdate=!1}g=this.type,_.needsUpdate=!1,n.setRenderTarget(G,F,D)};function v(C,b){let A=e.update(x);d.defines.VSM_SAMPLES!==C.blurSamples&&(d.defines.VSM_SAMPLES=C.blurSamples,p.defines.VSM_SAMPLES=C.blurSamples,d.needsUpdate=!0,p.needsUpdate=!0),C.mapPass===null?C.mapPass=new Ui(r.x,r.y,{format:Gs,type:xr}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),d.uniforms.shadow_pass.value=C.map.depthTexture,d.uniforms.resolution.value.set(C.map.width,C.map.height),d.uniforms.radius.value=C.radius,n.setRenderTarget(C.mapPass),n.clear(),n.renderBufferDirect(b,null,A,d,x,null),p.uniforms.shadow_pass.value=C.mapPass.texture,p.uniforms.resolution.value.set(C.map.width,C.map.height),p.uniforms.radius.value=C.radius,n.setRenderTarget(C.map),n.clear(),n.renderBufferDirect(b,null,A,p,x,null)}function E(C,b,A,G){let F=null,D=A.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(D!==void 0)F=D;else if(F=A.isPointLight===!0?l:a,n.localClippingEnabled&&b.clipShadows===!0&&Array.isArray(b.clippingPlanes)&&b.clippingPlanes.length!==0||b.displacementMap&&b.displacementScale!==0||b.alphaMap&&b.alphaTest>0||b.map&&b.alphaTest>0||b.alphaToCoverage===!0){let H=F.uuid,V=b.uuid,N=c[H];N===void 0&&(N={},c[H]=N);let W=N[V];W===void 0&&(W=F.clone(),N[V]=W,b.addEventListener("dispose",I)),F=W}if(F.visible=b.visible,F.wireframe=b.wireframe,G===Ta?F.side=b.shadowSide!==null?b.shadowSide:b.side:F.side=b.shadowSide!==null?b.shadowSide:f[b.side],F.alphaMap=b.alphaMap,F.alphaTest=b.alphaToCoverage===!0?.5:b.alphaTest,F.map=b.map,F.clipShadows=b.clipShadows,F.clippingPlanes=b.clippingPlanes,F.clipIntersection=b.clipIntersection,F.displacementMap=b.displacementMap,F.displacementScale=b.displacementScale,F.displacementBias=b.displacementBias,F.wireframeLinewidth=b.wireframeLinewidth,F.linewidth=b.linewidth,A.isPointLight===!0&&F.isMeshDistanceMaterial===!0){let H=n.properties.get(F);H.light=A}return F}function M(C,b,A,G,F,D){if(C.visible===!1)return;if(C.layers.test(F)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&D===Ta)&&(!C.frustumCulled||C.intersectsFrustum(i))){C.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,C.matrixWorld);let N=e.update(C),W=C.material;if(Array.isArray(W)){let K=N.groups;for(let z=0,ue=K.length;z<ue;z++){let j=K[z],ee=W[j.materialIndex];if(ee&&ee.visible){let se=E(C,ee,G,D);C.onBeforeShadow(n,C,b,A,N,se,j),n.renderBufferDirect(A,null,N,se,C,j),C.onAfterShadow(n,C,b,A,N,se,j)}}}else if(W.visible){let K=E(C,W,G,D);C.onBeforeShadow(n,C,b,A,N,K,null),n.renderBufferDirect(A,null,N,K,C,null),C.onAfterShadow(n,C,b,A,N,K,null)}}let V=C.children;for(let N=0,W=V.length;N<W;N++)M(V[N],b,A,G,F,D)}function I(C){C.target.removeEventListener("dispose",I);for(let A in c){let G=c[A],F=C.target.uuid;F in G&&(G[F].dispose(),delete G[F])}}}function JP(n,e){function t(){let U=!1,oe=new ln,ie=null,Ae=new ln(0,0,0,0);return{setMask:function(xe){ie!==xe&&!U&&(n.colorMask(xe,xe,xe,xe),ie=xe)},setLocked:function(xe){U=xe},setClear:function(xe,Me,Xe,tt,ce){ce===!0&&(xe*=tt,Me*=tt,Xe*=tt),oe.set(xe,Me,Xe,tt),Ae.equals(oe)===!1&&(n.clearColor(xe,Me,Xe,tt),Ae.copy(oe))},reset:function(){U=!1,ie=null,Ae.set(-1,0,0,0)}}}function i(){let U=!1,oe=!1,ie=null,Ae=null,xe=null;return{setReversed:function(Me){if(oe!==Me){let Xe=e.get("EXT_clip_control");Me?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),oe=Me;let tt=xe;xe=null,this.setClear(tt)}},getReversed:function(){return oe},setTest:function(Me){Me?we(n.DEPTH_TEST):qe(n.DEPTH_TEST)},setMask:function(Me){ie!==Me&&!U&&(n.depthMask(Me),ie=Me)},setFunc:function(Me){if(oe&&(Me=$y[Me]),Ae!==Me){switch(Me){case Su:n.depthFunc(n.NEVER);break;case Mu:n.depthFunc(n.ALWAYS);break;case wu:n.depthFunc(n.LESS);break;case ga:n.depthFunc(n.LEQUAL);break;case Tu:n.depthFunc(n.EQUAL);break;case Au:n.depthFunc(n.GEQUAL);break;case Eu:n.depthFunc(n.GREATER);break;case Cu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ae=Me}},setLocked:function(Me){U=Me},setClear:function(Me){xe!==Me&&(xe=Me,oe&&(Me=1-Me),n.clearDepth(Me))},reset:function(){U=!1,ie=null,Ae=null,xe=null,oe=!1}}}function r(){let U=!1,oe=null,ie=null,Ae=null,xe=null,Me=null,Xe=null,tt=null,ce=null;return{setTest:function(ze){U||(ze?we(n.STENCIL_TEST):qe(n.STENCIL_TEST))},setMask:function(ze){oe!==ze&&!U&&(n.stencilMask(ze),oe=ze)},setFunc:function(ze,nt,Pe){(ie!==ze||Ae!==nt||xe!==Pe)&&(n.stencilFunc(ze,nt,Pe),ie=ze,Ae=nt,xe=Pe)},setOp:function(ze,nt,Pe){(Me!==ze||Xe!==nt||tt!==Pe)&&(n.stencilOp(ze,nt,Pe),Me=ze,Xe=nt,tt=Pe)},setLocked:function(ze){U=ze},setClear:function(ze){ce!==ze&&(n.clearStencil(ze),ce=ze)},reset:function(){U=!1,oe=null,ie=null,Ae=null,xe=null,Me=null,Xe=null,tt=null,ce=null}}}let s=new t,o=new i,a=new r,l={},c=new WeakMap,h={},f={},d={},p=new WeakMap,m=[],x=null,_=!1,g=null,v=null,E=null,M=null,I=null,C=null,b=null,A=new Ct(0,0,0),G=0,F=!1,D=null,H=null,V=null,N=null,W=null,K=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,ue=0,j=n.getParameter(n.VERSION);j.indexOf("WebGL")!==-1?(ue=parseFloat(/^WebGL (\d)/.exec(j)[1]),z=ue>=1):j.indexOf("OpenGL ES")!==-1&&(ue=parseFloat(/^OpenGL ES (\d)/.exec(j)[1]),z=ue>=2);let ee=null,se={},fe=n.getParameter(n.SCISSOR_BOX),de=n.getParameter(n.VIEWPORT),te=new ln().fromArray(fe),_e=new ln().fromArray(de);function ve(U,oe,ie,Ae){let xe=new Uint8Array(4),Me=n.createTexture();n.bindTexture(U,Me),n.texParameteri(U,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(U,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Xe=0;Xe<ie;Xe++)U===n.TEXTURE_3D||U===n.TEXTURE_2D_ARRAY?n.texImage3D(oe,0,n.RGBA,1,1,Ae,0,n.RGBA,n.UNSIGNED_BYTE,xe):n.texImage2D(oe+Xe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xe);return Me}let Re={};Re[n.TEXTURE_2D]=ve(n.TEXTURE_2D,n.TEXTURE_2D,1),Re[n.TEXTURE_CUBE_MAP]=ve(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Re[n.TEXTURE_2D_ARRAY]=ve(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Re[n.TEXTURE_3D]=ve(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),we(n.DEPTH_TEST),o.setFunc(ga),yn(!1),Gt(zp),we(n.CULL_FACE),rn(mo);function we(U){h[U]!==!0&&(n.enable(U),h[U]=!0)}function qe(U){h[U]!==!1&&(n.disable(U),h[U]=!1)}function ct(U,oe){return d[U]!==oe?(n.bindFramebuffer(U,oe),d[U]=oe,U===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=oe),U===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=oe),!0):!1}function $e(U,oe){let ie=m,Ae=!1;if(U){ie=p.get(oe),ie===void 0&&(ie=[],p.set(oe,ie));let xe=U.textures;if(ie.length!==xe.length||ie[0]!==n.COLOR_ATTACHMENT0){for(let Me=0,Xe=xe.length;Me<Xe;Me++)ie[Me]=n.COLOR_ATTACHMENT0+Me;ie.length=xe.length,Ae=!0}}else ie[0]!==n.BACK&&(ie[0]=n.BACK,Ae=!0);Ae&&n.drawBuffers(ie)}function _t(U){return x!==U?(n.useProgram(U),x=U,!0):!1}let ft={[go]:n.FUNC_ADD,[py]:n.FUNC_SUBTRACT,[my]:n.FUNC_REVERSE_SUBTRACT};ft[gy]=n.MIN,ft[_y]=n.MAX;let at={[xy]:n.ZERO,[yy]:n.ONE,[vy]:n.SRC_COLOR,[$p]:n.SRC_ALPHA,[Ay]:n.SRC_ALPHA_SATURATE,[wy]:n.DST_COLOR,[Sy]:n.DST_ALPHA,[by]:n.ONE_MINUS_SRC_COLOR,[Xp]:n.ONE_MINUS_SRC_ALPHA,[Ty]:n.ONE_MINUS_DST_COLOR,[My]:n.ONE_MINUS_DST_ALPHA,[Ey]:n.CONSTANT_COLOR,[Cy]:n.ONE_MINUS_CONSTANT_COLOR,[Ry]:n.CONSTANT_ALPHA,[Py]:n.ONE_MINUS_CONSTANT_ALPHA};function rn(U,oe,ie,Ae,xe,Me,Xe,tt,ce,ze){if(U===mo){_===!0&&(qe(n.BLEND),_=!1);return}if(_===!1&&(we(n.BLEND),_=!0),U!==fy){if(U!==g||ze!==F){if((v!==go||I!==go)&&(n.blendEquation(n.FUNC_ADD),v=go,I=go),ze)switch(U){case Aa:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Hp:n.blendFunc(n.ONE,n.ONE);break;case Gp:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Wp:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:st("WebGLState: Invalid blending: ",U);break}else switch(U){case Aa:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Hp:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Gp:st("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Wp:st("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:st("WebGLState: Invalid blending: ",U);break}E=null,M=null,C=null,b=null,A.set(0,0,0),G=0,g=U,F=ze}return}xe=xe||oe,Me=Me||ie,Xe=Xe||Ae,(oe!==v||xe!==I)&&(n.blendEquationSeparate(ft[oe],ft[xe]),v=oe,I=xe),(ie!==E||Ae!==M||Me!==C||Xe!==b)&&(n.blendFuncSeparate(at[ie],at[Ae],at[Me],at[Xe]),E=ie,M=Ae,C=Me,b=Xe),(tt.equals(A)===!1||ce!==G)&&(n.blendColor(tt.r,tt.g,tt.b,ce),A.copy(tt),G=ce),g=U,F=!1}function Yt(U,oe){U.side===nr?qe(n.CULL_FACE):we(n.CULL_FACE);let ie=U.side===fi;oe&&(ie=!ie),yn(ie),U.blending===Aa&&U.transparent===!1?rn(mo):rn(U.blending,U.blendEquation,U.blendSrc,U.blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),o.setFunc(U.depthFunc),o.setTest(U.depthTest),o.setMask(U.depthWrite),s.setMask(U.colorWrite);let Ae=U.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(U.stencilWriteMask),a.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),a.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),At(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?we(n.SAMPLE_ALPHA_TO_COVERAGE):qe(n.SAMPLE_ALPHA_TO_COVERAGE)}function yn(U){D!==U&&(U?n.frontFace(n.CW):n.frontFace(n.CCW),D=U)}function Gt(U){U!==uy?(we(n.CULL_FACE),U!==H&&(U===zp?n.cullFace(n.BACK):U===hy?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):qe(n.CULL_FACE),H=U}function On(U){U!==V&&(z&&n.lineWidth(U),V=U)}function At(U,oe,ie){U?(we(n.POLYGON_OFFSET_FILL),(N!==oe||W!==ie)&&(N=oe,W=ie,o.getReversed()&&(oe=-oe,ie=-ie),n.polygonOffset(oe,ie))):qe(n.POLYGON_OFFSET_FILL)}function Pn(U){U?we(n.SCISSOR_TEST):qe(n.SCISSOR_TEST)}function cn(U){U===void 0&&(U=n.TEXTURE0+K-1),ee!==U&&(n.activeTexture(U),ee=U)}function vn(U,oe,ie){ie===void 0&&(ee===null?ie=n.TEXTURE0+K-1:ie=ee);let Ae=se[ie];Ae===void 0&&(Ae={type:void 0,texture:void 0},se[ie]=Ae),(Ae.type!==U||Ae.texture!==oe)&&(ee!==ie&&(n.activeTexture(ie),ee=ie),n.bindTexture(U,oe||Re[U]),Ae.type=U,Ae.texture=oe)}function k(){let U=se[ee];U!==void 0&&U.type!==void 0&&(n.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function Ie(){try{n.compressedTexImage2D(...arguments)}catch(U){st("WebGLState:",U)}}function Ze(){try{n.compressedTexImage3D(...arguments)}catch(U){st("WebGLState:",U)}}function ut(){try{n.texSubImage2D(...arguments)}catch(U){st("WebGLState:",U)}}function Te(){try{n.texSubImage3D(...arguments)}catch(U){st("WebGLState:",U)}}function $t(){try{n.compressedTexSubImage2D(...arguments)}catch(U){st("WebGLState:",U)}}function We(){try{n.compressedTexSubImage3D(...arguments)}catch(U){st("WebGLState:",U)}}function Je(){try{n.texStorage2D(...arguments)}catch(U){st("WebGLState:",U)}}function R(){try{n.texStorage3D(...arguments)}catch(U){st("WebGLState:",U)}}function S(){try{n.texImage2D(...arguments)}catch(U){st("WebGLState:",U)}}function $(){try{n.texImage3D(...arguments)}catch(U){st("WebGLState:",U)}}function he(U){return f[U]!==void 0?f[U]:n.getParameter(U)}function ae(U,oe){f[U]!==oe&&(n.pixelStorei(U,oe),f[U]=oe)}function ye(U){te.equals(U)===!1&&(n.scissor(U.x,U.y,U.z,U.w),te.copy(U))}function be(U){_e.equals(U)===!1&&(n.viewport(U.x,U.y,U.z,U.w),_e.copy(U))}function ne(U,oe){let ie=c.get(oe);ie===void 0&&(ie=new WeakMap,c.set(oe,ie));let Ae=ie.get(U);Ae===void 0&&(Ae=n.getUniformBlockIndex(oe,U.name),n.uniformBlockBinding(oe,Ae,Ae),ie.set(U,Ae))}function re(U,oe,ie){let xe=c.get(oe).get(U);l[xe]!==ie&&(n.bindBufferBase(n.UNIFORM_BUFFER,xe,ie),l[xe]=ie)}function me(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},f={},ee=null,se={},d={},l={},p=new WeakMap,m=[],x=null,_=!1,g=null,v=null,E=null,M=null,I=null,C=null,b=null,A=new Ct(0,0,0),G=0,F=!1,D=null,H=null,V=null,N=null,W=null,te.set(0,0,n.canvas.width,n.canvas.height),_e.set(0,0,n.canvas.width,n.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:we,disable:qe,bindFramebuffer:ct,drawBuffers:$e,useProgram:_t,setBlending:rn,setMaterial:Yt,setFlipSided:yn,setCullFace:Gt,setLineWidth:On,setPolygonOffset:At,setScissorTest:Pn,activeTexture:cn,bindTexture:vn,unbindTexture:k,compressedTexImage2D:Ie,compressedTexImage3D:Ze,texImage2D:S,texImage3D:$,pixelStorei:ae,getParameter:he,updateUBOMapping:ne,uniformBlockBinding:re,texStorage2D:Je,texStorage3D:R,texSubImage2D:ut,texSubImage3D:Te,compressedTexSubImage2D:$t,compressedTexSubImage3D:We,scissor:ye,viewport:be,reset:me}}function ZP(n,e,t,i,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Et,h=new WeakMap,f=new Set,d,p=new WeakMap,m=new Set,x=new FinalizationRegistry(R=>m.delete(R)),_=!1;try{_=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,S){return _?new OffscreenCanvas(R,S):xl("canvas")}function v(R,S,$){let he=1,ae=Je(R);if((ae.width>$||ae.height>$)&&(he=$/Math.max(ae.width,ae.height)),he<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ye=Math.floor(he*ae.width),be=Math.floor(he*ae.height);d===void 0&&(d=g(ye,be));let ne=S?g(ye,be):d;return ne.width=ye,ne.height=be,ne.getContext("2d").drawImage(R,0,0,ye,be),Ke("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+ye+"x"+be+")."),ne}else return"data"in R&&Ke("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),R;return R}function E(R){return R.generateMipmaps}function M(R){n.generateMipmap(R)}function I(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function C(R,S,$,he,ae,ye=!1){if(R!==null){if(n[R]!==void 0)return n[R];Ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let be;he&&(be=e.get("EXT_texture_norm16"),be||Ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=S;if(S===n.RED&&($===n.FLOAT&&(ne=n.R32F),$===n.HALF_FLOAT&&(ne=n.R16F),$===n.UNSIGNED_BYTE&&(ne=n.R8),$===n.UNSIGNED_SHORT&&be&&(ne=be.R16_EXT),$===n.SHORT&&be&&(ne=be.R16_SNORM_EXT)),S===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(ne=n.R8UI),$===n.UNSIGNED_SHORT&&(ne=n.R16UI),$===n.UNSIGNED_INT&&(ne=n.R32UI),$===n.BYTE&&(ne=n.R8I),$===n.SHORT&&(ne=n.R16I),$===n.INT&&(ne=n.R32I)),S===n.RG&&($===n.FLOAT&&(ne=n.RG32F),$===n.HALF_FLOAT&&(ne=n.RG16F),$===n.UNSIGNED_BYTE&&(ne=n.RG8),$===n.UNSIGNED_SHORT&&be&&(ne=be.RG16_EXT),$===n.SHORT&&be&&(ne=be.RG16_SNORM_EXT)),S===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(ne=n.RG8UI),$===n.UNSIGNED_SHORT&&(ne=n.RG16UI),$===n.UNSIGNED_INT&&(ne=n.RG32UI),$===n.BYTE&&(ne=n.RG8I),$===n.SHORT&&(ne=n.RG16I),$===n.INT&&(ne=n.RG32I)),S===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(ne=n.RGB8UI),$===n.UNSIGNED_SHORT&&(ne=n.RGB16UI),$===n.UNSIGNED_INT&&(ne=n.RGB32UI),$===n.BYTE&&(ne=n.RGB8I),$===n.SHORT&&(ne=n.RGB16I),$===n.INT&&(ne=n.RGB32I)),S===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(ne=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(ne=n.RGBA16UI),$===n.UNSIGNED_INT&&(ne=n.RGBA32UI),$===n.BYTE&&(ne=n.RGBA8I),$===n.SHORT&&(ne=n.RGBA16I),$===n.INT&&(ne=n.RGBA32I)),S===n.RGB&&($===n.UNSIGNED_SHORT&&be&&(ne=be.RGB16_EXT),$===n.SHORT&&be&&(ne=be.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(ne=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(ne=n.R11F_G11F_B10F)),S===n.RGBA){let re=ye?gl:bt.getTransfer(ae);$===n.FLOAT&&(ne=n.RGBA32F),$===n.HALF_FLOAT&&(ne=n.RGBA16F),$===n.UNSIGNED_BYTE&&(ne=re===kt?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&be&&(ne=be.RGBA16_EXT),$===n.SHORT&&be&&(ne=be.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(ne=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(ne=n.RGB5_A1)}return(ne===n.R16F||ne===n.R32F||ne===n.RG16F||ne===n.RG32F||ne===n.RGBA16F||ne===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function b(R,S){let $;return R?S===null||S===_r||S===xo?$=n.DEPTH24_STENCIL8:S===Vi?$=n.DEPTH32F_STENCIL8:S===Ca&&($=n.DEPTH24_STENCIL8,Ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===_r||S===xo?$=n.DEPTH_COMPONENT24:S===Vi?$=n.DEPTH_COMPONENT32F:S===Ca&&($=n.DEPTH_COMPONENT16),$}function A(R,S){return E(R)===!0||R.isFramebufferTexture&&R.minFilter!==Xn&&R.minFilter!==di?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function G(R){let S=new WeakRef(R);i.get(R).__ref=S,m.add(S),x.register(R,S,S)}function F(R){let S=i.get(R).__ref;S!==void 0&&(m.delete(S),x.unregister(S))}function D(R){V(R.target)}function H(R){N(R.target)}function V(R){R.removeEventListener("dispose",D),F(R),K(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&f.delete(R)}function N(R){R.removeEventListener("dispose",H),F(R),ue(R)}function W(){for(let R of m){let S=R.deref();S!==void 0&&(S.isRenderTarget===!0?N(S):V(S))}m.clear(),f.clear()}function K(R){let S=i.get(R);if(S.__webglInit===void 0)return;let $=R.source,he=p.get($);if(he){let ae=he[S.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&z(R),Object.keys(he).length===0&&p.delete($)}i.remove(R)}function z(R){let S=i.get(R);n.deleteTexture(S.__webglTexture);let $=R.source,he=p.get($);delete he[S.__cacheKey],o.memory.textures--}function ue(R){let S=i.get(R);S.__depthDisposeCallback&&S.__depthDisposeCallback();let $=R.depthTexture;if($&&$.renderTarget===R&&V($),R.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(S.__webglFramebuffer[ae]))for(let ye=0;ye<S.__webglFramebuffer[ae].length;ye++)n.deleteFramebuffer(S.__webglFramebuffer[ae][ye]);else n.deleteFramebuffer(S.__webglFramebuffer[ae]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[ae])}else{if(Array.isArray(S.__webglFramebuffer))for(let ae=0;ae<S.__webglFramebuffer.length;ae++)n.deleteFramebuffer(S.__webglFramebuffer[ae]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ae=0;ae<S.__webglColorRenderbuffer.length;ae++)S.__webglColorRenderbuffer[ae]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[ae]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let he=R.textures;for(let ae=0,ye=he.length;ae<ye;ae++){let be=i.get(he[ae]);be.__webglTexture&&(n.deleteTexture(be.__webglTexture),o.memory.textures--),i.remove(he[ae])}i.remove(R)}let j=0;function ee(){j=0}function se(){return j}function fe(R){j=R}function de(){let R=j;return R>=r.maxTextures&&Ke("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+r.maxTextures),j+=1,R}function te(R){let S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.mipmapsAutoUpdate),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function _e(R,S){let $=i.get(R);if(R.isVideoTexture&&$t(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&$.__version!==R.version){let he=R.image;if(he===null)Ke("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)Ke("WebGLRenderer: Texture marked for update but image is incomplete");else{Yt($,R,S);return}}else R.isExternalTexture&&($.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+S)}function ve(R,S){let $=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&$.__version!==R.version){Yt($,R,S);return}else R.isExternalTexture&&($.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+S)}function Re(R,S){let $=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&$.__version!==R.version){Yt($,R,S);return}t.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+S)}function we(R,S){let $=i.get(R);if(R.version>0&&$.__version!==R.version){yn($,R,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+S)}let qe={[Ru]:n.REPEAT,[Fr]:n.CLAMP_TO_EDGE,[Pu]:n.MIRRORED_REPEAT},ct={[Xn]:n.NEAREST,[Dy]:n.NEAREST_MIPMAP_NEAREST,[Nl]:n.NEAREST_MIPMAP_LINEAR,[di]:n.LINEAR,[sh]:n.LINEAR_MIPMAP_NEAREST,[as]:n.LINEAR_MIPMAP_LINEAR},$e={[ky]:n.NEVER,[dm]:n.ALWAYS,[Oy]:n.LESS,[um]:n.LEQUAL,[By]:n.EQUAL,[hm]:n.GEQUAL,[Vy]:n.GREATER,[zy]:n.NOTEQUAL};function _t(R,S){if(S.type===Vi&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===di||S.magFilter===sh||S.magFilter===Nl||S.magFilter===as||S.minFilter===di||S.minFilter===sh||S.minFilter===Nl||S.minFilter===as)&&Ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,qe[S.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,qe[S.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,qe[S.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,ct[S.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,ct[S.minFilter]),S.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,$e[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Xn||S.minFilter!==Nl&&S.minFilter!==as||S.type===Vi&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,r.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function ft(R,S){let $=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",D),G(S));let he=S.source,ae=p.get(he);ae===void 0&&(ae={},p.set(he,ae));let ye=te(S);if(ye!==R.__cacheKey){ae[ye]===void 0&&(ae[ye]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),ae[ye].usedTimes++;let be=ae[R.__cacheKey];be!==void 0&&(ae[R.__cacheKey].usedTimes--,be.usedTimes===0&&z(S)),R.__cacheKey=ye,R.__webglTexture=ae[ye].texture}return $}function at(R,S,$){return Math.floor(Math.floor(R/$)/S)}function rn(R,S,$,he){let ye=R.updateRanges;if(ye.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,$,he,S.data);else{ye.sort((U,oe)=>U.start-oe.start);let be=0;for(let U=1;U<ye.length;U++){let oe=ye[be],ie=ye[U],Ae=oe.start+oe.count,xe=at(ie.start,S.width,4),Me=at(oe.start,S.width,4);ie.start<=Ae+1&&xe===Me&&at(ie.start+ie.count-1,S.width,4)===xe?oe.count=Math.max(oe.count,ie.start+ie.count-oe.start):(++be,ye[be]=ie)}ye.length=be+1;let ne=t.getParameter(n.UNPACK_ROW_LENGTH),re=t.getParameter(n.UNPACK_SKIP_PIXELS),me=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let U=0,oe=ye.length;U<oe;U++){let ie=ye[U],Ae=Math.floor(ie.start/4),xe=Math.ceil(ie.count/4),Me=Ae%S.width,Xe=Math.floor(Ae/S.width),tt=xe,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(n.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(n.TEXTURE_2D,0,Me,Xe,tt,ce,$,he,S.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ne),t.pixelStorei(n.UNPACK_SKIP_PIXELS,re),t.pixelStorei(n.UNPACK_SKIP_ROWS,me)}}function Yt(R,S,$){let he=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(he=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(he=n.TEXTURE_3D);let ae=ft(R,S),ye=S.source;t.bindTexture(he,R.__webglTexture,n.TEXTURE0+$);let be=i.get(ye);if(ye.version!==be.__version||ae===!0){if(t.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ce=bt.getPrimaries(bt.workingColorSpace),ze=S.colorSpace===cs?null:bt.getPrimaries(S.colorSpace),nt=S.colorSpace===cs||ce===ze?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,nt)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let re=v(S.image,!1,r.maxTextureSize);re=We(S,re);let me=s.convert(S.format,S.colorSpace),U=s.convert(S.type),oe=C(S.internalFormat,me,U,S.normalized,S.colorSpace,S.isVideoTexture);_t(he,S);let ie,Ae=S.mipmaps,xe=S.isVideoTexture!==!0,Me=be.__version===void 0||ae===!0,Xe=ye.dataReady,tt=A(S,re);if(S.isDepthTexture)oe=b(S.format===ls,S.type),Me&&(xe?t.texStorage2D(n.TEXTURE_2D,1,oe,re.width,re.height):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,me,U,null));else if(S.isDataTexture)if(Ae.length>0){xe&&Me&&t.texStorage2D(n.TEXTURE_2D,tt,oe,Ae[0].width,Ae[0].height);for(let ce=0,ze=Ae.length;ce<ze;ce++)ie=Ae[ce],xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,me,U,ie.data):t.texImage2D(n.TEXTURE_2D,ce,oe,ie.width,ie.height,0,me,U,ie.data);S.generateMipmaps=!1}else xe?(Me&&t.texStorage2D(n.TEXTURE_2D,tt,oe,re.width,re.height),Xe&&rn(S,re,me,U)):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,me,U,re.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){xe&&Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,tt,oe,Ae[0].width,Ae[0].height,re.depth);for(let ce=0,ze=Ae.length;ce<ze;ce++)if(ie=Ae[ce],S.format!==zi)if(me!==null)if(xe){if(Xe)if(S.layerUpdates.size>0){let nt=_m(ie.width,ie.height,S.format,S.type);for(let Pe of S.layerUpdates){let ht=ie.data.subarray(Pe*nt/ie.data.BYTES_PER_ELEMENT,(Pe+1)*nt/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Pe,ie.width,ie.height,1,me,ht)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ie.width,ie.height,re.depth,me,ie.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,oe,ie.width,ie.height,re.depth,0,ie.data,0,0);else Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?Xe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ie.width,ie.height,re.depth,me,U,ie.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,oe,ie.width,ie.height,re.depth,0,me,U,ie.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{xe&&Me&&t.texStorage2D(n.TEXTURE_2D,tt,oe,Ae[0].width,Ae[0].height);for(let ce=0,ze=Ae.length;ce<ze;ce++)ie=Ae[ce],S.format!==zi?me!==null?xe?Xe&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,me,ie.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,oe,ie.width,ie.height,0,ie.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,me,U,ie.data):t.texImage2D(n.TEXTURE_2D,ce,oe,ie.width,ie.height,0,me,U,ie.data)}else if(S.isDataArrayTexture)if(xe){if(Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,tt,oe,re.width,re.height,re.depth),Xe)if(S.layerUpdates.size>0){let ce=_m(re.width,re.height,S.format,S.type);for(let ze of S.layerUpdates){let nt=re.data.subarray(ze*ce/re.data.BYTES_PER_ELEMENT,(ze+1)*ce/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ze,re.width,re.height,1,me,U,nt)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,me,U,re.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,oe,re.width,re.height,re.depth,0,me,U,re.data);else if(S.isData3DTexture)xe?(Me&&t.texStorage3D(n.TEXTURE_3D,tt,oe,re.width,re.height,re.depth),Xe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,me,U,re.data)):t.texImage3D(n.TEXTURE_3D,0,oe,re.width,re.height,re.depth,0,me,U,re.data);else if(S.isFramebufferTexture){if(Me)if(xe)t.texStorage2D(n.TEXTURE_2D,tt,oe,re.width,re.height);else{let ce=re.width,ze=re.height;for(let nt=0;nt<tt;nt++)t.texImage2D(n.TEXTURE_2D,nt,oe,ce,ze,0,me,U,null),ce>>=1,ze>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),re.parentNode!==ce){ce.appendChild(re),f.add(S),ce.onpaint=ze=>{let nt=ze.changedElements;for(let Pe of f)nt.includes(Pe.image)&&(Pe.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,re);else{let nt=n.RGBA,Pe=n.RGBA,ht=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,nt,Pe,ht,re)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(xe&&Me){let ce=Je(Ae[0]);t.texStorage2D(n.TEXTURE_2D,tt,oe,ce.width,ce.height)}for(let ce=0,ze=Ae.length;ce<ze;ce++)ie=Ae[ce],xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,me,U,ie):t.texImage2D(n.TEXTURE_2D,ce,oe,me,U,ie);S.generateMipmaps=!1}else if(xe){if(Me){let ce=Je(re);t.texStorage2D(n.TEXTURE_2D,tt,oe,ce.width,ce.height)}Xe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,me,U,re)}else t.texImage2D(n.TEXTURE_2D,0,oe,me,U,re);E(S)&&S.mipmapsAutoUpdate===!0&&M(he),be.__version=ye.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function yn(R,S,$){if(S.image.length!==6)return;let he=ft(R,S),ae=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+$);let ye=i.get(ae);if(ae.version!==ye.__version||he===!0){t.activeTexture(n.TEXTURE0+$);let be=bt.getPrimaries(bt.workingColorSpace),ne=S.colorSpace===cs?null:bt.getPrimaries(S.colorSpace),re=S.colorSpace===cs||be===ne?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let me=S.isCompressedTexture||S.image[0].isCompressedTexture,U=S.image[0]&&S.image[0].isDataTexture,oe=[];for(let Pe=0;Pe<6;Pe++)!me&&!U?oe[Pe]=v(S.image[Pe],!0,r.maxCubemapSize):oe[Pe]=U?S.image[Pe].image:S.image[Pe],oe[Pe]=We(S,oe[Pe]);let ie=oe[0],Ae=s.convert(S.format,S.colorSpace),xe=s.convert(S.type),Me=C(S.internalFormat,Ae,xe,S.normalized,S.colorSpace),Xe=S.isVideoTexture!==!0,tt=ye.__version===void 0||he===!0,ce=ae.dataReady,ze=A(S,ie);_t(n.TEXTURE_CUBE_MAP,S);let nt;if(S.isDepthTexture){if(Me=b(S.format===ls,S.type),tt)if(Xe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Me,ie.width,ie.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Me,ie.width,ie.height,0,Ae,xe,null)}else if(me){Xe&&tt&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,Me,ie.width,ie.height);for(let Pe=0;Pe<6;Pe++){nt=oe[Pe].mipmaps;for(let ht=0;ht<nt.length;ht++){let Kt=nt[ht];S.format!==zi?Ae!==null?Xe?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,0,0,Kt.width,Kt.height,Ae,Kt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,Me,Kt.width,Kt.height,0,Kt.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,0,0,Kt.width,Kt.height,Ae,xe,Kt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,Me,Kt.width,Kt.height,0,Ae,xe,Kt.data)}}}else{if(nt=S.mipmaps,Xe&&tt){nt.length>0&&ze++;let Pe=Je(oe[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,Me,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(U){Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,oe[Pe].width,oe[Pe].height,Ae,xe,oe[Pe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Me,oe[Pe].width,oe[Pe].height,0,Ae,xe,oe[Pe].data);for(let ht=0;ht<nt.length;ht++){let ii=nt[ht].image[Pe].image;Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,0,0,ii.width,ii.height,Ae,xe,ii.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,Me,ii.width,ii.height,0,Ae,xe,ii.data)}}else{Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Ae,xe,oe[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Me,Ae,xe,oe[Pe]);for(let ht=0;ht<nt.length;ht++){let Kt=nt[ht];Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,0,0,Ae,xe,Kt.image[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,Me,Ae,xe,Kt.image[Pe])}}}E(S)&&S.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),ye.__version=ae.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function Gt(R,S,$,he,ae,ye){let be=s.convert($.format,$.colorSpace),ne=s.convert($.type),re=C($.internalFormat,be,ne,$.normalized,$.colorSpace),me=i.get(S),U=i.get($);if(U.__renderTarget=S,!me.__hasExternalTextures){let oe=Math.max(1,S.width>>ye),ie=Math.max(1,S.height>>ye);ae===n.TEXTURE_3D||ae===n.TEXTURE_2D_ARRAY?t.texImage3D(ae,ye,re,oe,ie,S.depth,0,be,ne,null):t.texImage2D(ae,ye,re,oe,ie,0,be,ne,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Te(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,he,ae,U.__webglTexture,0,ut(S)):(ae===n.TEXTURE_2D||ae>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,he,ae,U.__webglTexture,ye),t.bindFramebuffer(n.FRAMEBUFFER,null)}function On(R,S,$){if(n.bindRenderbuffer(n.RENDERBUFFER,R),S.depthBuffer){let he=S.depthTexture,ae=he&&he.isDepthTexture?he.type:null,ye=b(S.stencilBuffer,ae),be=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Te(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ut(S),ye,S.width,S.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ut(S),ye,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,ye,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,be,n.RENDERBUFFER,R)}else{let he=S.textures;for(let ae=0;ae<he.length;ae++){let ye=he[ae],be=s.convert(ye.format,ye.colorSpace),ne=s.convert(ye.type),re=C(ye.internalFormat,be,ne,ye.normalized,ye.colorSpace);Te(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ut(S),re,S.width,S.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ut(S),re,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,re,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function At(R,S,$){let he=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=i.get(S.depthTexture);ae.__renderTarget=S;let ye=he?S.depthTexture.image[0]:S.depthTexture.image;(!ae.__webglTexture||ye.width!==S.width||ye.height!==S.height)&&(ye.width=S.width,ye.height=S.height,S.depthTexture.needsUpdate=!0),he?we(S.depthTexture,0):_e(S.depthTexture,0);let be=ae.__webglTexture,ne=ut(S),re=he?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,me=S.depthTexture.format===ls?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===ss)Te(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,re,be,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,me,re,be,0);else if(S.depthTexture.format===ls)Te(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,re,be,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,me,re,be,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Pn(R){let S=i.get(R),$=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){let he=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),he){let ae=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,he.removeEventListener("dispose",ae)};he.addEventListener("dispose",ae),S.__depthDisposeCallback=ae}S.__boundDepthTexture=he}if(R.depthTexture&&!S.__autoAllocateDepthBuffer)if($)for(let he=0;he<6;he++)At(S.__webglFramebuffer[he],R,he);else R.texture.mipmaps.length>0?At(S.__webglFramebuffer[0],R,0):At(S.__webglFramebuffer,R,0);else if($){S.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[he]),S.__webglDepthbuffer[he]===void 0)S.__webglDepthbuffer[he]=n.createRenderbuffer(),On(S.__webglDepthbuffer[he],R,!1);else{let ae=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=S.__webglDepthbuffer[he];n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,ye)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),On(S.__webglDepthbuffer,R,!1);else{let ae=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,ye)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function cn(R,S,$){let he=i.get(R);S!==void 0&&Gt(he.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&Pn(R)}function vn(R){let S=R.texture,$=i.get(R),he=i.get(S);R.addEventListener("dispose",H),G(R);let ae=R.textures,ye=R.isWebGLCubeRenderTarget===!0,be=ae.length>1;if(be||(he.__webglTexture===void 0&&(he.__webglTexture=n.createTexture()),he.__version=S.version,o.memory.textures++),ye){$.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(S.mipmaps.length>0){$.__webglFramebuffer[ne]=[];for(let re=0;re<S.mipmaps.length;re++)$.__webglFramebuffer[ne][re]=n.createFramebuffer()}else $.__webglFramebuffer[ne]=n.createFramebuffer()}else{if(S.mipmaps.length>0){$.__webglFramebuffer=[];for(let ne=0;ne<S.mipmaps.length;ne++)$.__webglFramebuffer[ne]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(be)for(let ne=0,re=ae.length;ne<re;ne++){let me=i.get(ae[ne]);me.__webglTexture===void 0&&(me.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Te(R)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let ne=0;ne<ae.length;ne++){let re=ae[ne];$.__webglColorRenderbuffer[ne]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[ne]);let me=s.convert(re.format,re.colorSpace),U=s.convert(re.type),oe=C(re.internalFormat,me,U,re.normalized,re.colorSpace,R.isXRRenderTarget===!0),ie=ut(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ie,oe,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ne,n.RENDERBUFFER,$.__webglColorRenderbuffer[ne])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),On($.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ye){t.bindTexture(n.TEXTURE_CUBE_MAP,he.__webglTexture),_t(n.TEXTURE_CUBE_MAP,S);for(let ne=0;ne<6;ne++)if(S.mipmaps.length>0)for(let re=0;re<S.mipmaps.length;re++)Gt($.__webglFramebuffer[ne][re],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,re);else Gt($.__webglFramebuffer[ne],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);E(S)?M(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(be){for(let ne=0,re=ae.length;ne<re;ne++){let me=ae[ne],U=i.get(me),oe=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(oe=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(oe,U.__webglTexture),_t(oe,me),Gt($.__webglFramebuffer,R,me,n.COLOR_ATTACHMENT0+ne,oe,0),E(me)&&M(oe)}t.unbindTexture()}else{let ne=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ne=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ne,he.__webglTexture),_t(ne,S),S.mipmaps.length>0)for(let re=0;re<S.mipmaps.length;re++)Gt($.__webglFramebuffer[re],R,S,n.COLOR_ATTACHMENT0,ne,re);else Gt($.__webglFramebuffer,R,S,n.COLOR_ATTACHMENT0,ne,0);E(S)?M(ne):S.mipmaps.length>0&&n.texParameteri(ne,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Pn(R)}function k(R){let S=R.textures;for(let $=0,he=S.length;$<he;$++){let ae=S[$];if(E(ae)&&ae.mipmapsAutoUpdate===!0){let ye=I(R),be=i.get(ae).__webglTexture;t.bindTexture(ye,be),M(ye),t.unbindTexture()}}}let Ie=[];function Ze(R){if(R.samples>0){if(Te(R)===!1){let S=R.textures,$=R.width,he=R.height,ae=n.COLOR_BUFFER_BIT,ye=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,be=i.get(R),ne=S.length>1;if(ne)for(let me=0;me<S.length;me++)t.bindFramebuffer(n.FRAMEBUFFER,be.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,be.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,be.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglFramebuffer);for(let me=0;me<S.length;me++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ae|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ae|=n.STENCIL_BUFFER_BIT)),ne){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,be.__webglColorRenderbuffer[me]);let U=i.get(S[me]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,U,0)}n.blitFramebuffer(0,0,$,he,0,0,$,he,ae,n.NEAREST),l===!0&&(Ie.length=0,Ie.push(n.COLOR_ATTACHMENT0+me),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Ie.push(ye),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ie))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ne)for(let me=0;me<S.length;me++){t.bindFramebuffer(n.FRAMEBUFFER,be.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,be.__webglColorRenderbuffer[me]);let U=i.get(S[me]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,be.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,U,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let S=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function ut(R){return Math.min(r.maxSamples,R.samples)}function Te(R){let S=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function $t(R){let S=o.render.frame;h.get(R)!==S&&(h.set(R,S),R.update())}function We(R,S){let $=R.colorSpace,he=R.format,ae=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||$!==lo&&$!==cs&&(bt.getTransfer($)===kt?(he!==zi||ae!==Bi)&&Ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):st("WebGLTextures: Unsupported texture color space:",$)),S}function Je(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=de,this.resetTextureUnits=ee,this.getTextureUnits=se,this.setTextureUnits=fe,this.setTexture2D=_e,this.setTexture2DArray=ve,this.setTexture3D=Re,this.setTextureCube=we,this.rebindTextures=cn,this.setupRenderTarget=vn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Ze,this.setupDepthRenderbuffer=Pn,this.setupFrameBufferTexture=Gt,this.useMultisampledRTT=Te,this.dispose=W}function KP(n,e){function t(i,r=cs){let s,o=bt.getTransfer(r);if(i===Bi)return n.UNSIGNED_BYTE;if(i===ah)return n.UNSIGNED_SHORT_4_4_4_4;if(i===lh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===rm)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===sm)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===nm)return n.BYTE;if(i===im)return n.SHORT;if(i===Ca)return n.UNSIGNED_SHORT;if(i===oh)return n.INT;if(i===_r)return n.UNSIGNED_INT;if(i===Vi)return n.FLOAT;if(i===xr)return n.HALF_FLOAT;if(i===om)return n.ALPHA;if(i===am)return n.RGB;if(i===zi)return n.RGBA;if(i===ss)return n.DEPTH_COMPONENT;if(i===ls)return n.DEPTH_STENCIL;if(i===lm)return n.RED;if(i===ch)return n.RED_INTEGER;if(i===Gs)return n.RG;if(i===uh)return n.RG_INTEGER;if(i===hh)return n.RGBA_INTEGER;if(i===Fl||i===Ul||i===kl||i===Ol)if(o===kt)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===Fl)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ul)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===kl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ol)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===Fl)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ul)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===kl)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ol)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===dh||i===fh||i===ph||i===mh)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===dh)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===fh)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ph)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===mh)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===gh||i===_h||i===xh||i===yh||i===vh||i===Bl||i===bh)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===gh||i===_h)return o===kt?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===xh)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===yh)return s.COMPRESSED_R11_EAC;if(i===vh)return s.COMPRESSED_SIGNED_R11_EAC;if(i===Bl)return s.COMPRESSED_RG11_EAC;if(i===bh)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Sh||i===Mh||i===wh||i===Th||i===Ah||i===Eh||i===Ch||i===Rh||i===Ph||i===Ih||i===Lh||i===Dh||i===Nh||i===Fh)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===Sh)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Mh)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===wh)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Th)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Ah)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Eh)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Ch)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Rh)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Ph)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Ih)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Lh)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Dh)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Nh)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Fh)return o===kt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Uh||i===kh||i===Oh)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===Uh)return o===kt?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===kh)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Oh)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Bh||i===Vh||i===Vl||i===zh)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===Bh)return s.COMPRESSED_RED_RGTC1_EXT;if(i===Vh)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Vl)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===zh)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===xo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var jP=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,QP=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Am=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Rl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Or({vertexShader:jP,fragmentShader:QP,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Jn(new Pl(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Em=class extends Ur{constructor(e,t){super();let i=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,h=null,f=null,d=null,p=null,m=null,x=typeof XRWebGLBinding<"u",_=new Am,g={},v=t.getContextAttributes(),E=null,M=null,I=[],C=[],b=new Et,A=null,G=null,F=new Fi;F.viewport=new ln;let D=new Fi;D.viewport=new ln;let H=[F,D],V=new nh,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(te){let _e=I[te];return _e===void 0&&(_e=new ya,I[te]=_e),_e.getTargetRaySpace()},this.getControllerGrip=function(te){let _e=I[te];return _e===void 0&&(_e=new ya,I[te]=_e),_e.getGripSpace()},this.getHand=function(te){let _e=I[te];return _e===void 0&&(_e=new ya,I[te]=_e),_e.getHandSpace()};function K(te){let _e=C.indexOf(te.inputSource);if(_e===-1)return;let ve=I[_e];ve!==void 0&&(ve.update(te.inputSource,te.frame,c||o),ve.dispatchEvent({type:te.type,data:te.inputSource}))}function z(){r.removeEventListener("select",K),r.removeEventListener("selectstart",K),r.removeEventListener("selectend",K),r.removeEventListener("squeeze",K),r.removeEventListener("squeezestart",K),r.removeEventListener("squeezeend",K),r.removeEventListener("end",z),r.removeEventListener("inputsourceschange",ue);for(let te=0;te<I.length;te++){let _e=C[te];_e!==null&&(C[te]=null,I[te].disconnect(_e))}N=null,W=null,_.reset();for(let te in g)delete g[te];if(e.setRenderTarget(E),p=null,d=null,f=null,r=null,M=null,de.stop(),i.isPresenting=!1,e.setPixelRatio(A),e.setSize(b.width,b.height,!1),G!==null){let te=G.camera;te.fov=G.fov,te.zoom=G.zoom,te.updateProjectionMatrix(),G=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(te){s=te,i.isPresenting===!0&&Ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(te){a=te,i.isPresenting===!0&&Ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(te){c=te},this.getBaseLayer=function(){return d!==null?d:p},this.getBinding=function(){return f===null&&x&&(f=new XRWebGLBinding(r,t)),f},this.getFrame=function(){return m},this.getSession=function(){return r},this.setSession=async function(te){if(r=te,r!==null){if(E=e.getRenderTarget(),r.addEventListener("select",K),r.addEventListener("selectstart",K),r.addEventListener("selectend",K),r.addEventListener("squeeze",K),r.addEventListener("squeezestart",K),r.addEventListener("squeezeend",K),r.addEventListener("end",z),r.addEventListener("inputsourceschange",ue),v.xrCompatible!==!0&&await t.makeXRCompatible(),A=e.getPixelRatio(),e.getSize(b),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Re=null,we=null;v.depth&&(we=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=v.stencil?ls:ss,Re=v.stencil?xo:_r);let qe={colorFormat:t.RGBA8,depthFormat:we,scaleFactor:s};f=this.getBinding(),d=f.createProjectionLayer(qe),r.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),M=new Ui(d.textureWidth,d.textureHeight,{format:zi,type:Bi,depthTexture:new os(d.textureWidth,d.textureHeight,Re,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ve={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:s};p=new XRWebGLLayer(r,t,ve),r.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),M=new Ui(p.framebufferWidth,p.framebufferHeight,{format:zi,type:Bi,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),de.setContext(r),de.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return _.getDepthTexture()};function ue(te){for(let _e=0;_e<te.removed.length;_e++){let ve=te.removed[_e],Re=C.indexOf(ve);Re>=0&&(C[Re]=null,I[Re].disconnect(ve))}for(let _e=0;_e<te.added.length;_e++){let ve=te.added[_e],Re=C.indexOf(ve);if(Re===-1){for(let qe=0;qe<I.length;qe++)if(qe>=C.length){C.push(ve),Re=qe;break}else if(C[qe]===null){C[qe]=ve,Re=qe;break}if(Re===-1)break}let we=I[Re];we&&we.connect(ve)}}function j(te,_e){_e===null?te.matrixWorld.copy(te.matrix):te.matrixWorld.multiplyMatrices(_e.matrixWorld,te.matrix),te.matrixWorldInverse.copy(te.matrixWorld).invert()}this.updateCamera=function(te){if(r===null)return;let _e=te.near,ve=te.far;_.texture!==null&&(_.depthNear>0&&(_e=_.depthNear),_.depthFar>0&&(ve=_.depthFar)),V.near=D.near=F.near=_e,V.far=D.far=F.far=ve,(N!==V.near||W!==V.far)&&(r.updateRenderState({depthNear:V.near,depthFar:V.far}),N=V.near,W=V.far),V.layers.mask=te.layers.mask|6,F.layers.mask=V.layers.mask&-5,D.layers.mask=V.layers.mask&-3;let Re=te.parent,we=V.cameras;j(V,Re);for(let qe=0;qe<we.length;qe++)j(we[qe],Re);V.projectionMatrix.copy(F.projectionMatrix),V.projectionMatrixInverse.copy(F.projectionMatrixInverse),G===null&&te.isPerspectiveCamera&&(G={camera:te,fov:te.fov,zoom:te.zoom}),ee(te,V,Re)};function ee(te,_e,ve){ve===null?te.matrix.copy(_e.matrixWorld):(te.matrix.copy(ve.matrixWorld),te.matrix.invert(),te.matrix.multiply(_e.matrixWorld)),te.matrix.decompose(te.position,te.quaternion,te.scale),te.updateMatrixWorld(!0),te.projectionMatrix.copy(_e.projectionMatrix),te.projectionMatrixInverse.copy(_e.projectionMatrixInverse),te.isPerspectiveCamera&&(te.fov=Lu*2*Math.atan(1/te.projectionMatrix.elements[5]),te.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&p===null))return l},this.setFoveation=function(te){l=te,d!==null&&(d.fixedFoveation=te),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=te)},this.hasDepthSensing=function(){return _.texture!==null},this.getDepthSensingMesh=function(){return _.getMesh(V)},this.getCameraTexture=function(te){return g[te]};let se=null;function fe(te,_e){if(h=_e.getViewerPose(c||o),m=_e,h!==null){let ve=h.views;p!==null&&(e.setRenderTargetFramebuffer(M,p.framebuffer),e.setRenderTarget(M));let Re=!1;ve.length!==V.cameras.length&&(V.cameras.length=0,Re=!0);for(let $e=0;$e<ve.length;$e++){let _t=ve[$e],ft=null;if(p!==null)ft=p.getViewport(_t);else{let rn=f.getViewSubImage(d,_t);ft=rn.viewport,$e===0&&(e.setRenderTargetTextures(M,rn.colorTexture,rn.depthStencilTexture),e.setRenderTarget(M))}let at=H[$e];at===void 0&&(at=new Fi,at.layers.enable($e),at.viewport=new ln,H[$e]=at),at.matrix.fromArray(_t.transform.matrix),at.matrix.decompose(at.position,at.quaternion,at.scale),at.projectionMatrix.fromArray(_t.projectionMatrix),at.projectionMatrixInverse.copy(at.projectionMatrix).invert(),at.viewport.set(ft.x,ft.y,ft.width,ft.height),$e===0&&(V.matrix.copy(at.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Re===!0&&V.cameras.push(at)}let we=r.enabledFeatures;if(we&&we.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&x){f=i.getBinding();let $e=f.getDepthInformation(ve[0]);$e&&$e.isValid&&$e.texture&&_.init($e,r.renderState)}if(we&&we.includes("camera-access")&&x){e.state.unbindTexture(),f=i.getBinding();for(let $e=0;$e<ve.length;$e++){let _t=ve[$e].camera;if(_t){let ft=g[_t];ft||(ft=new Rl,g[_t]=ft);let at=f.getCameraImage(_t);ft.sourceTexture=at}}}}for(let ve=0;ve<I.length;ve++){let Re=C[ve],we=I[ve];Re!==null&&we!==void 0&&we.update(Re,_e,c||o)}se&&se(te,_e),_e.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:_e}),m=null}let de=new vv;de.setAnimationLoop(fe),this.setAnimationLoop=function(te){se=te},this.dispose=function(){}}},e2=new Zt,Pv=new ot;Pv.set(-1,0,0,0,1,0,0,0,1);function t2(n,e){function t(_,g){_.matrixAutoUpdate===!0&&_.updateMatrix(),g.value.copy(_.matrix)}function i(_,g){g.color.getRGB(_.fogColor.value,pm(n)),g.isFog?(_.fogNear.value=g.near,_.fogFar.value=g.far):g.isFogExp2&&(_.fogDensity.value=g.density)}function r(_,g,v,E,M){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?s(_,g):g.isMeshLambertMaterial?(s(_,g),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(s(_,g),f(_,g)):g.isMeshPhongMaterial?(s(_,g),h(_,g),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(s(_,g),d(_,g),g.isMeshPhysicalMaterial&&p(_,g,M)):g.isMeshMatcapMaterial?(s(_,g),m(_,g)):g.isMeshDepthMaterial?s(_,g):g.isMeshDistanceMaterial?(s(_,g),x(_,g)):g.isMeshNormalMaterial?s(_,g):g.isLineBasicMaterial?(o(_,g),g.isLineDashedMaterial&&a(_,g)):g.isPointsMaterial?l(_,g,v,E):g.isSpriteMaterial?c(_,g):g.isShadowMaterial?(_.color.value.copy(g.color),_.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function s(_,g){_.opacity.value=g.opacity,g.color&&_.diffuse.value.copy(g.color),g.emissive&&_.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(_.map.value=g.map,t(g.map,_.mapTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.bumpMap&&(_.bumpMap.value=g.bumpMap,t(g.bumpMap,_.bumpMapTransform),_.bumpScale.value=g.bumpScale,g.side===fi&&(_.bumpScale.value*=-1)),g.normalMap&&(_.normalMap.value=g.normalMap,t(g.normalMap,_.normalMapTransform),_.normalScale.value.copy(g.normalScale),g.side===fi&&_.normalScale.value.negate()),g.displacementMap&&(_.displacementMap.value=g.displacementMap,t(g.displacementMap,_.displacementMapTransform),_.displacementScale.value=g.displacementScale,_.displacementBias.value=g.displacementBias),g.emissiveMap&&(_.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,_.emissiveMapTransform)),g.specularMap&&(_.specularMap.value=g.specularMap,t(g.specularMap,_.specularMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest);let v=e.get(g),E=v.envMap,M=v.envMapRotation;E&&(_.envMap.value=E,_.envMapRotation.value.setFromMatrix4(e2.makeRotationFromEuler(M)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&_.envMapRotation.value.premultiply(Pv),_.reflectivity.value=g.reflectivity,_.ior.value=g.ior,_.refractionRatio.value=g.refractionRatio),g.lightMap&&(_.lightMap.value=g.lightMap,_.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,_.lightMapTransform)),g.aoMap&&(_.aoMap.value=g.aoMap,_.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,_.aoMapTransform))}function o(_,g){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,g.map&&(_.map.value=g.map,t(g.map,_.mapTransform))}function a(_,g){_.dashSize.value=g.dashSize,_.totalSize.value=g.dashSize+g.gapSize,_.scale.value=g.scale}function l(_,g,v,E){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,_.size.value=g.size*v,_.scale.value=E*.5,g.map&&(_.map.value=g.map,t(g.map,_.uvTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest)}function c(_,g){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,_.rotation.value=g.rotation,g.map&&(_.map.value=g.map,t(g.map,_.mapTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest)}function h(_,g){_.specular.value.copy(g.specular),_.shininess.value=Math.max(g.shininess,1e-4)}function f(_,g){g.gradientMap&&(_.gradientMap.value=g.gradientMap)}function d(_,g){_.metalness.value=g.metalness,g.metalnessMap&&(_.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,_.metalnessMapTransform)),_.roughness.value=g.roughness,g.roughnessMap&&(_.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,_.roughnessMapTransform)),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)}function p(_,g,v){_.ior.value=g.ior,g.diffuseRoughness>0&&(_.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(_.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,_.diffuseRoughnessMapTransform))),g.sheen>0&&(_.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),_.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(_.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,_.sheenColorMapTransform)),g.sheenRoughnessMap&&(_.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,_.sheenRoughnessMapTransform))),g.clearcoat>0&&(_.clearcoat.value=g.clearcoat,_.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(_.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,_.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(_.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,_.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(_.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,_.clearcoatNormalMapTransform),_.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===fi&&_.clearcoatNormalScale.value.negate())),g.dispersion>0&&(_.dispersion.value=g.dispersion),g.retroreflectivity>0&&(_.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(_.iridescence.value=g.iridescence,_.iridescenceIOR.value=g.iridescenceIOR,_.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,_.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(_.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,_.iridescenceMapTransform)),g.iridescenceThicknessMap&&(_.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,_.iridescenceThicknessMapTransform))),g.transmission>0&&(_.transmission.value=g.transmission,_.transmissionSamplerMap.value=v.texture,_.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(_.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,_.transmissionMapTransform)),_.thickness.value=g.thickness,g.thicknessMap&&(_.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,_.thicknessMapTransform)),_.attenuationDistance.value=g.attenuationDistance,_.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(_.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(_.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,_.anisotropyMapTransform))),_.specularIntensity.value=g.specularIntensity,_.specularColor.value.copy(g.specularColor),g.specularColorMap&&(_.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,_.specularColorMapTransform)),g.specularIntensityMap&&(_.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,_.specularIntensityMapTransform))}function m(_,g){g.matcap&&(_.matcap.value=g.matcap)}function x(_,g){let v=e.get(g).light;_.referencePosition.value.setFromMatrixPosition(v.matrixWorld),_.nearDistance.value=v.shadow.camera.near,_.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function n2(n,e,t,i){let r={},s={};function o(v,E){let M=E.program;i.uniformBlockBinding(v,M,r[v.id])}function a(v,E){let M=r[v.id];M===void 0&&(m(v),M=l(v),r[v.id]=M,v.addEventListener("dispose",_));let I=E.program;i.updateUBOMapping(v,I);let C=e.render.frame;s[v.id]!==C&&(c(v),s[v.id]=C)}function l(v){let E=n.createBuffer(),M=v.__size,I=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,E),n.bufferData(n.UNIFORM_BUFFER,M,I),n.bindBuffer(n.UNIFORM_BUFFER,null),E}function c(v){let E=r[v.id],M=v.uniforms,I=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let C=0,b=M.length;C<b;C++){let A=M[C];if(Array.isArray(A))for(let G=0,F=A.length;G<F;G++)h(A[G],C,G,I);else h(A,C,0,I)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(v,E,M,I){if(d(v,E,M,I)===!0){let C=v.__offset,b=v.value;if(Array.isArray(b)){let A=0;for(let G=0;G<b.length;G++){let F=b[G],D=x(F,!0);f(F,v.__data,A),A+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else f(b,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,C,v.__data)}}function f(v,E,M){typeof v=="number"||typeof v=="boolean"?E[M]=v:v.isMatrix3?(E[M]=v.elements[0],E[M+1]=v.elements[1],E[M+2]=v.elements[2],E[M+3]=0,E[M+4]=v.elements[3],E[M+5]=v.elements[4],E[M+6]=v.elements[5],E[M+7]=0,E[M+8]=v.elements[6],E[M+9]=v.elements[7],E[M+10]=v.elements[8],E[M+11]=0):ArrayBuffer.isView(v)?E.set(v.subarray(0,E.length-M),M):v.toArray(E,M)}function d(v,E,M,I){let C=v.value,b=E+"_"+M;if(Array.isArray(C)){I[b]===void 0&&(I[b]=[]);let A=I[b],G=!1;for(let F=0;F<C.length;F++)p(C[F],A,F)===!0&&(G=!0);return G}return p(C,I,b)}function p(v,E,M){if(E[M]===void 0)return typeof v=="number"||typeof v=="boolean"?E[M]=v:ArrayBuffer.isView(v)?E[M]=v.slice():E[M]=v.clone(),!0;{let I=E[M];if(typeof v=="number"||typeof v=="boolean"){if(I!==v)return E[M]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(I.equals(v)===!1)return I.copy(v),!0}}return!1}function m(v){let E=v.uniforms,M=0,I=16;for(let b=0,A=E.length;b<A;b++){let G=Array.isArray(E[b])?E[b]:[E[b]];for(let F=0,D=G.length;F<D;F++){let H=G[F],V=Array.isArray(H.value)?H.value:[H.value],N=Array.isArray(E[b])||Array.isArray(H.value),W=M;for(let z=0,ue=V.length;z<ue;z++){let j=V[z],ee=x(j,N),se=M%I,fe=se%ee.boundary,de=se+fe;M+=fe,de!==0&&I-de<ee.storage&&(M+=I-de),z===0&&(W=M),M+=ee.storage}let K=H.type==="int"?Int32Array:H.type==="uint"?Uint32Array:Float32Array;H.__data=new K((M-W)/Float32Array.BYTES_PER_ELEMENT),H.__offset=W}}let C=M%I;return C>0&&(M+=I-C),v.__size=M,v.__cache={},this}function x(v,E){let M={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(M.boundary=4,M.storage=4):v.isVector2?(M.boundary=8,M.storage=8):v.isVector3||v.isColor?(M.boundary=16,M.storage=12):v.isVector4?(M.boundary=16,M.storage=16):v.isMatrix3?(M.boundary=16,M.storage=48):v.isMatrix4?(M.boundary=16,M.storage=64):v.isTexture?Ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(M.boundary=16,M.storage=v.byteLength):Ke("WebGLRenderer: Unsupported uniform value type.",v),E===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function _(v){let E=v.target;E.removeEventListener("dispose",_),n.deleteBuffer(r[E.id]),delete r[E.id],delete s[E.id]}function g(){for(let v in r)n.deleteBuffer(r[v]);r={},s={}}return{bind:o,update:a,dispose:g}}var i2=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Vr=null;function r2(){return Vr===null&&(Vr=new va(i2,16,16,Gs,xr),Vr.name="DFG_LUT",Vr.minFilter=di,Vr.magFilter=di,Vr.wrapS=Fr,Vr.wrapT=Fr,Vr.generateMipmaps=!1,Vr.needsUpdate=!0),Vr}var Xh=class{constructor(e={}){let{canvas:t=Hy(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:d=!1,outputBufferType:p=Bi}=e;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let x=p,_=new Set([hh,uh,ch]),g=new Set([Bi,_r,Ca,xo,ah,lh]),v=new Uint32Array(4),E=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},I=null,C=null,b=[],A=[],G=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Br,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let F=this,D=!1,H=null,V=null,N=null,W=null;this._outputColorSpace=Di;let K=0,z=0,ue=null,j=-1,ee=null,se=new ln,fe=new ln,de=null,te=new Ct(0),_e=0,ve=t.width,Re=t.height,we=1,qe=null,ct=null,$e=new ln(0,0,ve,Re),_t=new ln(0,0,ve,Re),ft=!1,at=new ho,rn=new Ou,Yt=!1,yn=!1,Gt=new Zt,On=new X,At=new ln,Pn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},cn=!1;function vn(){return ue===null?we:1}let k=i;function Ie(T,O){return t.getContext(T,O)}let Ze,ut,Te,$t,We,Je,R,S,$,he,ae,ye,be,ne,re,me,U,oe,ie,Ae,xe,Me,Xe;try{let T={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",nt,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),k===null){let O="webgl2";if(k=Ie(O,T),k===null)throw Ie(O)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}tt()}catch(T){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),st("WebGLRenderer: "+T.message),T}function tt(){Ze=new mR(k),Ze.init(),xe=new KP(k,Ze),ut=new rR(k,Ze,e,xe),Te=new JP(k,Ze),ut.reversedDepthBuffer&&d&&Te.buffers.depth.setReversed(!0),V=k.createFramebuffer(),N=k.createFramebuffer(),W=k.createFramebuffer(),$t=new xR(k),We=new FP,Je=new ZP(k,Ze,Te,We,ut,xe,$t),R=new pR(F),S=new vA(k),Me=new nR(k,S),$=new gR(k,S,$t,Me),he=new vR(k,$,S,Me,$t),oe=new yR(k,ut,Je),re=new sR(We),ae=new NP(F,R,Ze,ut,Me,re),ye=new t2(F,We),be=new kP,ne=new GP(Ze),U=new tR(F,R,Te,he,m,l),me=new YP(F,he,ut),Xe=new n2(k,$t,ut,Te),ie=new iR(k,Ze,$t),Ae=new _R(k,Ze,$t),$t.programs=ae.programs,F.capabilities=ut,F.extensions=Ze,F.properties=We,F.renderLists=be,F.shadowMap=me,F.state=Te,F.info=$t}x!==Bi&&(G=new SR(x,t.width,t.height,a,r,s));let ce=new Em(F,k);this.xr=ce,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let T=Ze.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Ze.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return we},this.setPixelRatio=function(T){T!==void 0&&(we=T,this.setSize(ve,Re,!1))},this.getSize=function(T){return T.set(ve,Re)},this.setSize=function(T,O,Q=!0){if(ce.isPresenting){Ke("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=T,Re=O,t.width=Math.floor(T*we),t.height=Math.floor(O*we),Q===!0&&(t.style.width=T+"px",t.style.height=O+"px"),G!==null&&G.setSize(t.width,t.height),this.setViewport(0,0,T,O)},this.getDrawingBufferSize=function(T){return T.set(ve*we,Re*we).floor()},this.setDrawingBufferSize=function(T,O,Q){ve=T,Re=O,we=Q,t.width=Math.floor(T*Q),t.height=Math.floor(O*Q),this.setViewport(0,0,T,O)},this.setEffects=function(T){if(x===Bi){st("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let O=0;O<T.length;O++)if(T[O].isOutputPass===!0){Ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}G.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(se)},this.getViewport=function(T){return T.copy($e)},this.setViewport=function(T,O,Q,q){T.isVector4?$e.set(T.x,T.y,T.z,T.w):$e.set(T,O,Q,q),Te.viewport(se.copy($e).multiplyScalar(vn()).round())},this.getScissor=function(T){return T.copy(_t)},this.setScissor=function(T,O,Q,q){T.isVector4?_t.set(T.x,T.y,T.z,T.w):_t.set(T,O,Q,q),Te.scissor(fe.copy(_t).multiplyScalar(vn()).round())},this.getScissorTest=function(){return ft},this.setScissorTest=function(T){Te.setScissorTest(ft=T)},this.setOpaqueSort=function(T){qe=T},this.setTransparentSort=function(T){ct=T},this.getClearColor=function(T){return T.copy(U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){U.setClearAlpha(...arguments)},this.clear=function(T=!0,O=!0,Q=!0){let q=0;if(T){let Y=!1;if(ue!==null){let Ee=ue.texture.format;Y=_.has(Ee)}if(Y){let Ee=ue.texture.type,Le=g.has(Ee),Ce=U.getClearColor(),De=U.getClearAlpha(),Ge=Ce.r,rt=Ce.g,yt=Ce.b;Le?(v[0]=Ge,v[1]=rt,v[2]=yt,v[3]=De,k.clearBufferuiv(k.COLOR,0,v)):(E[0]=Ge,E[1]=rt,E[2]=yt,E[3]=De,k.clearBufferiv(k.COLOR,0,E))}else q|=k.COLOR_BUFFER_BIT}O&&(q|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(q|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&k.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),H=T},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),U.dispose(),be.dispose(),ne.dispose(),Je.dispose(),We.dispose(),R.dispose(),he.dispose(),$.dispose(),Me.dispose(),Xe.dispose(),ae.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",nc),ce.removeEventListener("sessionend",br),Gr.stop()};function ze(T){T.preventDefault(),yl("WebGLRenderer: Context Lost."),D=!0}function nt(){yl("WebGLRenderer: Context Restored."),D=!1;let T=$t.autoReset,O=me.enabled,Q=me.autoUpdate,q=me.needsUpdate,Y=me.type;tt(),$t.autoReset=T,me.enabled=O,me.autoUpdate=Q,me.needsUpdate=q,me.type=Y}function Pe(T){st("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function ht(T){let O=T.target;O.removeEventListener("dispose",ht),Kt(O)}function Kt(T){ii(T),We.remove(T)}function ii(T){let O=We.get(T).programs;O!==void 0&&(O.forEach(function(Q){ae.releaseProgram(Q)}),T.isShaderMaterial&&ae.releaseShaderCache(T))}this.renderBufferDirect=function(T,O,Q,q,Y,Ee){O===null&&(O=Pn);let Le=Y.isMesh&&Y.matrixWorld.determinantAffine()<0,Ce=Ba(T,O,Q,q,Y);Te.setMaterial(q,Le);let De=Q.index,Ge=1;if(q.wireframe===!0){if(De=$.getWireframeAttribute(Q),De===void 0)return;Ge=2}let rt=Q.drawRange,yt=Q.attributes.position,He=rt.start*Ge,vt=(rt.start+rt.count)*Ge;Ee!==null&&(He=Math.max(He,Ee.start*Ge),vt=Math.min(vt,(Ee.start+Ee.count)*Ge)),De!==null?(He=Math.max(He,0),vt=Math.min(vt,De.count)):yt!=null&&(He=Math.max(He,0),vt=Math.min(vt,yt.count));let on=vt-He;if(on<0||on===1/0)return;Me.setup(Y,q,Ce,Q,De);let Ot,Bt=ie;if(De!==null&&(Ot=S.get(De),Bt=Ae,Bt.setIndex(Ot)),Y.isMesh)q.wireframe===!0?(Te.setLineWidth(q.wireframeLinewidth*vn()),Bt.setMode(k.LINES)):Bt.setMode(k.TRIANGLES);else if(Y.isLine){let In=q.linewidth;In===void 0&&(In=1),Te.setLineWidth(In*vn()),Y.isLineSegments?Bt.setMode(k.LINES):Y.isLineLoop?Bt.setMode(k.LINE_LOOP):Bt.setMode(k.LINE_STRIP)}else Y.isPoints?Bt.setMode(k.POINTS):Y.isSprite&&Bt.setMode(k.TRIANGLES);if(Y.isBatchedMesh)if(Ze.get("WEBGL_multi_draw"))Bt.renderMultiDraw(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount);else{let In=Y._multiDrawStarts,Be=Y._multiDrawCounts,bn=Y._multiDrawCount,Mt=De?S.get(De).bytesPerElement:1,$r=We.get(q).currentProgram.getUniforms();for(let Sn=0;Sn<bn;Sn++)$r.setValue(k,"_gl_DrawID",Sn),Bt.render(In[Sn]/Mt,Be[Sn])}else if(Y.isInstancedMesh)Bt.renderInstances(He,on,Y.count);else if(Q.isInstancedBufferGeometry){let In=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Be=Math.min(Q.instanceCount,In);Bt.renderInstances(He,on,Be)}else Bt.render(He,on)};function Ua(T,O,Q,q){H!==null&&T.isNodeMaterial&&H.setObject(q,T),Yt===!0&&re.setState(T,Q,!1),T.transparent===!0&&T.side===nr&&T.forceSinglePass===!1?(T.side=fi,T.needsUpdate=!0,Sr(T,O,q),T.side=Hs,T.needsUpdate=!0,Sr(T,O,q),T.side=nr):Sr(T,O,q)}this.compile=function(T,O,Q=null){Q===null&&(Q=T),H!==null&&H.renderStart(T,O,Q),C=ne.get(Q),C.init(O),A.push(C),Q.traverseVisible(function(Y){Y.isLight&&Y.layers.test(O.layers)&&(C.pushLight(Y),Y.castShadow&&C.pushShadow(Y))}),T!==Q&&T.traverseVisible(function(Y){Y.isLight&&Y.layers.test(O.layers)&&(C.pushLight(Y),Y.castShadow&&C.pushShadow(Y))}),C.setupLights(),H!==null&&H.updateLights(C.state.lightsArray),yn=this.localClippingEnabled,Yt=re.init(this.clippingPlanes,yn),Yt===!0&&re.setGlobalState(this.clippingPlanes,O),H!==null&&me.render(C.state.shadowsArray,Q,O);let q=new Set;return T.traverse(function(Y){if(!(Y.isMesh||Y.isPoints||Y.isLine||Y.isSprite))return;let Ee=Y.material;if(Ee)if(Array.isArray(Ee))for(let Le=0;Le<Ee.length;Le++){let Ce=Ee[Le];Ua(Ce,Q,O,Y),q.add(Ce)}else Ua(Ee,Q,O,Y),q.add(Ee)}),C=A.pop(),H!==null&&H.renderEnd(),q},this.compileAsync=function(T,O,Q=null){let q=this.compile(T,O,Q);return new Promise(Y=>{function Ee(){if(q.forEach(function(Le){let De=We.get(Le).currentProgram;(De===void 0||De.isReady())&&q.delete(Le)}),q.size===0){Y(T);return}setTimeout(Ee,10)}Ze.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let Mo=null;function Jd(T){Mo&&Mo(T)}function nc(){Gr.stop()}function br(){Gr.start()}let Gr=new vv;Gr.setAnimationLoop(Jd),typeof self<"u"&&Gr.setContext(self),this.setAnimationLoop=function(T){Mo=T,ce.setAnimationLoop(T),T===null?Gr.stop():Gr.start()},ce.addEventListener("sessionstart",nc),ce.addEventListener("sessionend",br),this.render=function(T,O){if(O!==void 0&&O.isCamera!==!0){st("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;H!==null&&H.renderStart(T,O);let Q=ce.enabled===!0&&ce.isPresenting===!0,q=G!==null&&(ue===null||Q)&&G.begin(F,ue);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),O.parent===null&&O.matrixWorldAutoUpdate===!0&&O.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(G===null||G.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(O),O=ce.getCamera()),T.isScene===!0&&T.onBeforeRender(F,T,O,ue),C=ne.get(T,A.length),C.init(O),C.state.textureUnits=Je.getTextureUnits(),A.push(C),Gt.multiplyMatrices(O.projectionMatrix,O.matrixWorldInverse),O.isArrayCamera?rn.setFromArrayCamera(O):at.setFromProjectionMatrix(Gt,er,O.reversedDepth),yn=this.localClippingEnabled,Yt=re.init(this.clippingPlanes,yn),I=be.get(T,b.length),I.init(),b.push(I),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Le=F.xr.getDepthSensingMesh();Le!==null&&Wr(Le,O,-1/0,F.sortObjects)}Wr(T,O,0,F.sortObjects),I.finish(),H!==null&&H.updateLights(C.state.lightsArray),F.sortObjects===!0&&I.sort(qe,ct),cn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,cn&&U.addToRenderList(I,T),this.info.autoReset===!0&&this.info.reset(),Yt===!0&&re.beginShadows();let Y=C.state.shadowsArray;if(me.render(Y,T,O),Yt===!0&&re.endShadows(),(q&&G.hasRenderPass())===!1){let Le=I.opaque,Ce=I.transmissive;if(C.setupLights(),O.isArrayCamera){let De=O.cameras;if(Ce.length>0)for(let Ge=0,rt=De.length;Ge<rt;Ge++){let yt=De[Ge];ir(Le,Ce,T,yt)}cn&&U.render(T);for(let Ge=0,rt=De.length;Ge<rt;Ge++){let yt=De[Ge];ka(I,T,yt,yt.viewport)}}else Ce.length>0&&ir(Le,Ce,T,O),cn&&U.render(T),ka(I,T,O)}ue!==null&&z===0&&(Je.updateMultisampleRenderTarget(ue),Je.updateRenderTargetMipmap(ue)),q&&G.end(F),T.isScene===!0&&T.onAfterRender(F,T,O),Me.resetDefaultState(),j=-1,ee=null,A.pop(),A.length>0?(C=A[A.length-1],Je.setTextureUnits(C.state.textureUnits),Yt===!0&&re.setGlobalState(F.clippingPlanes,C.state.camera)):C=null,b.pop(),b.length>0?I=b[b.length-1]:I=null,H!==null&&H.renderEnd()};function Wr(T,O,Q,q){if(T.visible===!1)return;if(T.layers.test(O.layers)){if(T.isGroup)Q=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(O);else if(T.isLight)C.pushLight(T),T.castShadow&&C.pushShadow(T);else if(T.isSprite){let Le=O.isArrayCamera?rn:at;if(!T.frustumCulled||T.intersectsFrustum(Le)){q&&At.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Gt);let Ce=he.update(T),De=T.material;De.visible&&I.push(T,Ce,De,Q,At.z,null,O)}}else if(T.isMesh||T.isLine||T.isPoints){let Le=O.isArrayCamera?rn:at;if(!T.frustumCulled||T.intersectsFrustum(Le)){let Ce=he.update(T),De=T.material;if(q&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),At.copy(T.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),At.copy(Ce.boundingSphere.center)),At.applyMatrix4(T.matrixWorld).applyMatrix4(Gt)),Array.isArray(De)){let Ge=Ce.groups;for(let rt=0,yt=Ge.length;rt<yt;rt++){let He=Ge[rt],vt=De[He.materialIndex];vt&&vt.visible&&I.push(T,Ce,vt,Q,At.z,He,O)}}else De.visible&&I.push(T,Ce,De,Q,At.z,null,O)}}}let Ee=T.children;for(let Le=0,Ce=Ee.length;Le<Ce;Le++)Wr(Ee[Le],O,Q,q)}function ka(T,O,Q,q){let{opaque:Y,transmissive:Ee,transparent:Le}=T;C.setupLightsView(Q),Yt===!0&&re.setGlobalState(F.clippingPlanes,Q),q&&Te.viewport(se.copy(q)),Y.length>0&&un(Y,O,Q),Ee.length>0&&un(Ee,O,Q),Le.length>0&&un(Le,O,Q),Te.buffers.depth.setTest(!0),Te.buffers.depth.setMask(!0),Te.buffers.color.setMask(!0),Te.setPolygonOffset(!1)}function ir(T,O,Q,q){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[q.id]===void 0){let He=Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[q.id]=new Ui(1,1,{generateMipmaps:!0,type:He?xr:Bi,minFilter:as,samples:Math.max(4,ut.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:bt.workingColorSpace})}let Ee=C.state.transmissionRenderTarget[q.id],Le=q.viewport||se;Ee.setSize(Le.z*F.transmissionResolutionScale,Le.w*F.transmissionResolutionScale);let Ce=F.getRenderTarget(),De=F.getActiveCubeFace(),Ge=F.getActiveMipmapLevel();F.setRenderTarget(Ee),F.getClearColor(te),_e=F.getClearAlpha(),_e<1&&F.setClearColor(16777215,.5),F.clear(),cn&&U.render(Q);let rt=F.toneMapping;F.toneMapping=Br;let yt=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),C.setupLightsView(q),Yt===!0&&re.setGlobalState(F.clippingPlanes,q),un(T,Q,q),Je.updateMultisampleRenderTarget(Ee),Je.updateRenderTargetMipmap(Ee),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let He=!1;for(let vt=0,on=O.length;vt<on;vt++){let Ot=O[vt],{object:Bt,geometry:In,material:Be,group:bn}=Ot;if(Be.side===nr&&Bt.layers.test(q.layers)){let Mt=Be.side;Be.side=fi,Be.needsUpdate=!0,mn(Bt,Q,q,In,Be,bn),Be.side=Mt,Be.needsUpdate=!0,He=!0}}He===!0&&(Je.updateMultisampleRenderTarget(Ee),Je.updateRenderTargetMipmap(Ee))}F.setRenderTarget(Ce,De,Ge),F.setClearColor(te,_e),yt!==void 0&&(q.viewport=yt),F.toneMapping=rt}function un(T,O,Q){let q=O.isScene===!0?O.overrideMaterial:null;for(let Y=0,Ee=T.length;Y<Ee;Y++){let Le=T[Y],{object:Ce,geometry:De,group:Ge}=Le,rt=Le.material;rt.allowOverride===!0&&q!==null&&(rt=q),Ce.layers.test(Q.layers)&&mn(Ce,O,Q,De,rt,Ge)}}function mn(T,O,Q,q,Y,Ee){H!==null&&Y.isNodeMaterial&&H.setObject(T,Y),T.onBeforeRender(F,O,Q,q,Y,Ee),T.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),Y.onBeforeRender(F,O,Q,q,T,Ee),Y.transparent===!0&&Y.side===nr&&Y.forceSinglePass===!1?(Y.side=fi,Y.needsUpdate=!0,F.renderBufferDirect(Q,O,q,Y,T,Ee),Y.side=Hs,Y.needsUpdate=!0,F.renderBufferDirect(Q,O,q,Y,T,Ee),Y.side=nr):F.renderBufferDirect(Q,O,q,Y,T,Ee),T.onAfterRender(F,O,Q,q,Y,Ee)}function gn(T){let O=0;for(let Q of T)Q.texture!==null&&O++;return O}function Sr(T,O,Q){O.isScene!==!0&&(O=Pn);let q=We.get(T),Y=C.state.lights,Ee=C.state.shadowsArray,Le=Y.state.version,Ce=ae.getParameters(T,Y.state,Ee,O,Q,C.state.lightProbeGridArray),De=ae.getProgramCacheKey(Ce),Ge=q.programs;q.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?O.environment:null,q.fog=O.fog;let rt=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;q.envMap=R.get(T.envMap||q.environment,rt),q.envMapRotation=q.environment!==null&&T.envMap===null?O.environmentRotation:T.envMapRotation,Ge===void 0&&(T.addEventListener("dispose",ht),Ge=new Map,q.programs=Ge,q.programVariants=new Map);let yt=Ge.get(De);if(yt!==void 0){if(q.currentProgram===yt&&q.lightsStateVersion===Le)return Oa(T,Ce),yt}else Ce.uniforms=ae.getUniforms(T),H!==null&&T.isNodeMaterial&&H.build(T,Q,Ce),T.onBeforeCompile(Ce,F),yt=ae.acquireProgram(Ce,De),Ge.set(De,yt),q.uniforms=Ce.uniforms;let He=q.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(He.clippingPlanes=re.uniform),Oa(T,Ce),q.needsLights=ms(T),q.lightsStateVersion=Le,q.needsLights&&(He.ambientLightColor.value=Y.state.ambient,He.lightProbe.value=Y.state.probe,He.sunLights.value=Y.state.sun,He.sunLightShadows.value=Y.state.sunShadow,He.directionalLights.value=Y.state.directional,He.directionalLightShadows.value=Y.state.directionalShadow,He.spotLights.value=Y.state.spot,He.spotLightShadows.value=Y.state.spotShadow,He.rectAreaLights.value=Y.state.rectArea,He.ltc_1.value=Y.state.rectAreaLTC1,He.ltc_2.value=Y.state.rectAreaLTC2,He.pointLights.value=Y.state.point,He.pointLightShadows.value=Y.state.pointShadow,He.hemisphereLights.value=Y.state.hemi,He.sunShadowMatrix.value=Y.state.sunShadowMatrix,He.sunShadowCascade.value=Y.state.sunShadowCascade,He.directionalShadowMatrix.value=Y.state.directionalShadowMatrix,He.spotLightMatrix.value=Y.state.spotLightMatrix,He.spotLightMap.value=Y.state.spotLightMap,He.pointShadowMatrix.value=Y.state.pointShadowMatrix),q.numLightProbeGrids=gn(C.state.lightProbeGridArray),q.currentProgram=yt,q.uniformsList=null,yt}function vi(T,O,Q,q,Y){let Ee=We.get(T),Le=Ee.currentProgram.id+","+q+","+Y,Ce=Ee.programVariants.get(Le);return Ce===void 0?(Ce=Sr(T,O,Q),Ee.programVariants.set(Le,Ce)):(Ee.currentProgram=Ce,Ee.uniformsList=null,Ee.outputColorSpace=q,Ee.toneMapping=Y),Ce}function ps(T){if(T.uniformsList===null){let O=T.currentProgram.getUniforms();T.uniformsList=Ra.seqWithValue(O.seq,T.uniforms)}return T.uniformsList}function Oa(T,O){let Q=We.get(T);Q.outputColorSpace=O.outputColorSpace,Q.batching=O.batching,Q.batchingColor=O.batchingColor,Q.instancing=O.instancing,Q.instancingColor=O.instancingColor,Q.instancingMorph=O.instancingMorph,Q.skinning=O.skinning,Q.morphTargets=O.morphTargets,Q.morphNormals=O.morphNormals,Q.morphColors=O.morphColors,Q.morphTargetsCount=O.morphTargetsCount,Q.numClippingPlanes=O.numClippingPlanes,Q.numIntersection=O.numClipIntersection,Q.vertexAlphas=O.vertexAlphas,Q.vertexTangents=O.vertexTangents,Q.toneMapping=O.toneMapping}function Ba(T,O,Q,q,Y){O.isScene!==!0&&(O=Pn),Je.resetTextureUnits();let Ee=O.fog,Le=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?O.environment:null,Ce=ue===null?F.outputColorSpace:ue.isXRRenderTarget===!0?ue.texture.colorSpace:bt.workingColorSpace,De=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,Ge=R.get(q.envMap||Le,De),rt=q.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,yt=!!Q.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),He=!!Q.morphAttributes.position,vt=!!Q.morphAttributes.normal,on=!!Q.morphAttributes.color,Ot=Br;q.toneMapped&&(ue===null||ue.isXRRenderTarget===!0)&&(Ot=F.toneMapping);let Bt=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,In=Bt!==void 0?Bt.length:0,Be=We.get(q),bn=C.state.lights;if(Yt===!0&&(yn===!0||T!==ee)){let Vt=T===ee&&q.id===j;re.setState(q,T,Vt)}let Mt=!1,$r=!1;q.version===Be.__version?Be.needsLights&&Be.lightsStateVersion!==bn.state.version||Y.isBatchedMesh&&Be.batching===!1||!Y.isBatchedMesh&&Be.batching===!0||Y.isBatchedMesh&&Be.batchingColor===!0&&Y._colorsTexture===null||Y.isBatchedMesh&&Be.batchingColor===!1&&Y._colorsTexture!==null||Y.isInstancedMesh&&Be.instancing===!1||!Y.isInstancedMesh&&Be.instancing===!0||Y.isSkinnedMesh&&Be.skinning===!1||!Y.isSkinnedMesh&&Be.skinning===!0||Y.isInstancedMesh&&Be.instancingColor===!0&&Y.instanceColor===null||Y.isInstancedMesh&&Be.instancingColor===!1&&Y.instanceColor!==null||Y.isInstancedMesh&&Be.instancingMorph===!0&&Y.morphTexture===null||Y.isInstancedMesh&&Be.instancingMorph===!1&&Y.morphTexture!==null||Be.envMap!==Ge||q.fog===!0&&Be.fog!==Ee||Be.numClippingPlanes!==void 0&&(Be.numClippingPlanes!==re.numPlanes||Be.numIntersection!==re.numIntersection)||Be.vertexAlphas!==rt||Be.vertexTangents!==yt||Be.morphTargets!==He||Be.morphNormals!==vt||Be.morphColors!==on||Be.morphTargetsCount!==In||Be.numLightProbeGrids!==gn(C.state.lightProbeGridArray)?Mt=!0:(Be.outputColorSpace!==Ce||Be.toneMapping!==Ot)&&($r=!0):(Mt=!0,Be.__version=q.version);let Sn=Be.currentProgram;(Mt===!0||$r===!0)&&(Sn=$r===!0?vi(q,O,Y,Ce,Ot):Sr(q,O,Y),H&&q.isNodeMaterial&&H.onUpdateProgram(q,Sn,Be));let Ao=!1,Mr=!1,Xr=!1,pt=Sn.getUniforms(),hn=Be.uniforms;if(Te.useProgram(Sn.program)&&(Ao=!0,Mr=!0,Xr=!0),q.id!==j&&(j=q.id,Mr=!0),Ao||ee!==T){Te.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),pt.setValue(k,"projectionMatrix",T.projectionMatrix),pt.setValue(k,"viewMatrix",T.matrixWorldInverse);let Mn=pt.map.cameraPosition;Mn!==void 0&&Mn.setValue(k,On.setFromMatrixPosition(T.matrixWorld)),ut.logarithmicDepthBuffer&&pt.setValue(k,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&pt.setValue(k,"isOrthographic",T.isOrthographicCamera===!0),ee!==T&&(ee=T,Mr=!0,Xr=!0)}if(Be.needsLights&&(bn.state.sunShadowMap.length>0&&pt.setValue(k,"sunShadowMap",bn.state.sunShadowMap,Je),bn.state.directionalShadowMap.length>0&&pt.setValue(k,"directionalShadowMap",bn.state.directionalShadowMap,Je),bn.state.spotShadowMap.length>0&&pt.setValue(k,"spotShadowMap",bn.state.spotShadowMap,Je),bn.state.pointShadowMap.length>0&&pt.setValue(k,"pointShadowMap",bn.state.pointShadowMap,Je)),Y.isSkinnedMesh){pt.setOptional(k,Y,"bindMatrix"),pt.setOptional(k,Y,"bindMatrixInverse");let Vt=Y.skeleton;Vt&&(Vt.boneTexture===null&&Vt.computeBoneTexture(),pt.setValue(k,"boneTexture",Vt.boneTexture,Je))}Y.isBatchedMesh&&(pt.setOptional(k,Y,"batchingTexture"),pt.setValue(k,"batchingTexture",Y._matricesTexture,Je),pt.setOptional(k,Y,"batchingIdTexture"),pt.setValue(k,"batchingIdTexture",Y._indirectTexture,Je),pt.setOptional(k,Y,"batchingColorTexture"),Y._colorsTexture!==null&&pt.setValue(k,"batchingColorTexture",Y._colorsTexture,Je));let ri=Q.morphAttributes;if((ri.position!==void 0||ri.normal!==void 0||ri.color!==void 0)&&oe.update(Y,Q,Sn),(Mr||Be.receiveShadow!==Y.receiveShadow)&&(Be.receiveShadow=Y.receiveShadow,pt.setValue(k,"receiveShadow",Y.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&O.environment!==null&&(hn.envMapIntensity.value=O.environmentIntensity),hn.dfgLUT!==void 0&&(hn.dfgLUT.value=r2()),Mr){if(pt.setValue(k,"toneMappingExposure",F.toneMappingExposure),Be.needsLights&&wo(hn,Xr),Ee&&q.fog===!0&&ye.refreshFogUniforms(hn,Ee),ye.refreshMaterialUniforms(hn,q,we,Re,C.state.transmissionRenderTarget[T.id]),Be.needsLights&&Be.numLightProbeGrids>0){let Vt=M,Mn=0;for(let Kn of C.state.lightProbeGridArray)Kn.texture!==null&&(Vt.textures[Mn]=Kn.texture,Vt.min[Mn]=Kn.boundingBox.min,Vt.max[Mn]=Kn.boundingBox.max,Vt.resolution[Mn]=Kn.resolution,Mn++);for(let Kn in Vt)Vt[Kn].length=Mn;hn.probesSH.value=Vt.textures,hn.probesMin.value=Vt.min,hn.probesMax.value=Vt.max,hn.probesResolution.value=Vt.resolution}Ra.upload(k,ps(Be),hn,Je)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(Ra.upload(k,ps(Be),hn,Je),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&pt.setValue(k,"center",Y.center),pt.setValue(k,"modelViewMatrix",Y.modelViewMatrix),pt.setValue(k,"normalMatrix",Y.normalMatrix),pt.setValue(k,"modelMatrix",Y.matrixWorld),q.uniformsGroups!==void 0){let Vt=q.uniformsGroups;for(let Mn=0,Kn=Vt.length;Mn<Kn;Mn++){let ic=Vt[Mn];Xe.update(ic,Sn),Xe.bind(ic,Sn)}}return Sn}function wo(T,O){T.ambientLightColor.needsUpdate=O,T.lightProbe.needsUpdate=O,T.sunLights.needsUpdate=O,T.sunLightShadows.needsUpdate=O,T.directionalLights.needsUpdate=O,T.directionalLightShadows.needsUpdate=O,T.pointLights.needsUpdate=O,T.pointLightShadows.needsUpdate=O,T.spotLights.needsUpdate=O,T.spotLightShadows.needsUpdate=O,T.rectAreaLights.needsUpdate=O,T.hemisphereLights.needsUpdate=O}function ms(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return K},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return ue},this.setRenderTargetTextures=function(T,O,Q){let q=We.get(T);q.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),We.get(T.texture).__webglTexture=O,We.get(T.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:Q,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,O){let Q=We.get(T);Q.__webglFramebuffer=O,Q.__useDefaultFramebuffer=O===void 0},this.setRenderTarget=function(T,O=0,Q=0){ue=T,K=O,z=Q;let q=null,Y=!1,Ee=!1;if(T){let Ce=We.get(T);if(Ce.__useDefaultFramebuffer!==void 0){Te.bindFramebuffer(k.FRAMEBUFFER,Ce.__webglFramebuffer),se.copy(T.viewport),fe.copy(T.scissor),de=T.scissorTest,Te.viewport(se),Te.scissor(fe),Te.setScissorTest(de),j=-1;return}else if(Ce.__webglFramebuffer===void 0)Je.setupRenderTarget(T);else if(Ce.__hasExternalTextures)Je.rebindTextures(T,We.get(T.texture).__webglTexture,We.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let rt=T.depthTexture;if(Ce.__boundDepthTexture!==rt){if(rt!==null&&We.has(rt)&&(T.width!==rt.image.width||T.height!==rt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Je.setupDepthRenderbuffer(T)}}let De=T.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ee=!0);let Ge=We.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(Ge[O])?q=Ge[O][Q]:q=Ge[O],Y=!0):T.samples>0&&Je.useMultisampledRTT(T)===!1?q=We.get(T).__webglMultisampledFramebuffer:Array.isArray(Ge)?q=Ge[Q]:q=Ge,se.copy(T.viewport),fe.copy(T.scissor),de=T.scissorTest}else se.copy($e).multiplyScalar(we).floor(),fe.copy(_t).multiplyScalar(we).floor(),de=ft;if(Q!==0&&(q=V),Te.bindFramebuffer(k.FRAMEBUFFER,q)&&Te.drawBuffers(T,q),Te.viewport(se),Te.scissor(fe),Te.setScissorTest(de),Y){let Ce=We.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+O,Ce.__webglTexture,Q)}else if(Ee){let Ce=O;for(let De=0;De<T.textures.length;De++){let Ge=We.get(T.textures[De]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+De,Ge.__webglTexture,Q,Ce)}}else if(T!==null&&Q!==0){let Ce=We.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Ce.__webglTexture,Q)}j=-1};function To(T){let O=We.get(T);return(O.__readFormat!==T.format||O.__readType!==T.type)&&(O.__readFormat=T.format,O.__readType=T.type,O.__formatReadable=ut.textureFormatReadable(T.format),O.__typeReadable=ut.textureTypeReadable(T.type)),O}this.readRenderTargetPixels=function(T,O,Q,q,Y,Ee,Le,Ce=0){if(!(T&&T.isWebGLRenderTarget)){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=We.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De){Te.bindFramebuffer(k.FRAMEBUFFER,De);try{let Ge=T.textures[Ce],rt=Ge.format,yt=Ge.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ce);let He=To(Ge);if(He.__formatReadable===!1){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(He.__typeReadable===!1){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}O>=0&&O<=T.width-q&&Q>=0&&Q<=T.height-Y&&k.readPixels(O,Q,q,Y,xe.convert(rt),xe.convert(yt),Ee)}finally{let Ge=ue!==null?We.get(ue).__webglFramebuffer:null;Te.bindFramebuffer(k.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(T,O,Q,q,Y,Ee,Le,Ce=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=We.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De)if(O>=0&&O<=T.width-q&&Q>=0&&Q<=T.height-Y){Te.bindFramebuffer(k.FRAMEBUFFER,De);let Ge=T.textures[Ce],rt=Ge.format,yt=Ge.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ce);let He=To(Ge);if(He.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(He.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let vt=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,vt),k.bufferData(k.PIXEL_PACK_BUFFER,Ee.byteLength,k.STREAM_READ),k.readPixels(O,Q,q,Y,xe.convert(rt),xe.convert(yt),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let on=ue!==null?We.get(ue).__webglFramebuffer:null;Te.bindFramebuffer(k.FRAMEBUFFER,on);let Ot=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await Wy(k,Ot,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,vt),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Ee),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(vt),k.deleteSync(Ot),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,O=null,Q=0){let q=Math.pow(2,-Q),Y=Math.floor(T.image.width*q),Ee=Math.floor(T.image.height*q),Le=O!==null?O.x:0,Ce=O!==null?O.y:0;Je.setTexture2D(T,0),k.copyTexSubImage2D(k.TEXTURE_2D,Q,0,0,Le,Ce,Y,Ee),Te.unbindTexture()},this.copyTextureToTexture=function(T,O,Q=null,q=null,Y=0,Ee=0){let Le,Ce,De,Ge,rt,yt,He,vt,on,Ot=T.isCompressedTexture?T.mipmaps[Ee]:T.image;if(Q!==null)Le=Q.max.x-Q.min.x,Ce=Q.max.y-Q.min.y,De=Q.isBox3?Q.max.z-Q.min.z:1,Ge=Q.min.x,rt=Q.min.y,yt=Q.isBox3?Q.min.z:0;else{let pt=Math.pow(2,-Y);Le=Math.floor(Ot.width*pt),Ce=Math.floor(Ot.height*pt),T.isDataArrayTexture?De=Ot.depth:T.isData3DTexture?De=Math.floor(Ot.depth*pt):De=1,Ge=0,rt=0,yt=0}q!==null?(He=q.x,vt=q.y,on=q.z):(He=0,vt=0,on=0);let Bt=xe.convert(O.format),In=xe.convert(O.type),Be;O.isData3DTexture?(Je.setTexture3D(O,0),Be=k.TEXTURE_3D):O.isDataArrayTexture||O.isCompressedArrayTexture?(Je.setTexture2DArray(O,0),Be=k.TEXTURE_2D_ARRAY):(Je.setTexture2D(O,0),Be=k.TEXTURE_2D),Te.activeTexture(k.TEXTURE0),Te.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,O.flipY),Te.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,O.premultiplyAlpha),Te.pixelStorei(k.UNPACK_ALIGNMENT,O.unpackAlignment);let bn=Te.getParameter(k.UNPACK_ROW_LENGTH),Mt=Te.getParameter(k.UNPACK_IMAGE_HEIGHT),$r=Te.getParameter(k.UNPACK_SKIP_PIXELS),Sn=Te.getParameter(k.UNPACK_SKIP_ROWS),Ao=Te.getParameter(k.UNPACK_SKIP_IMAGES);Te.pixelStorei(k.UNPACK_ROW_LENGTH,Ot.width),Te.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Ot.height),Te.pixelStorei(k.UNPACK_SKIP_PIXELS,Ge),Te.pixelStorei(k.UNPACK_SKIP_ROWS,rt),Te.pixelStorei(k.UNPACK_SKIP_IMAGES,yt);let Mr=T.isDataArrayTexture||T.isData3DTexture,Xr=O.isDataArrayTexture||O.isData3DTexture;if(T.isDepthTexture){let pt=We.get(T),hn=We.get(O),ri=We.get(pt.__renderTarget),Vt=We.get(hn.__renderTarget);Te.bindFramebuffer(k.READ_FRAMEBUFFER,ri.__webglFramebuffer),Te.bindFramebuffer(k.DRAW_FRAMEBUFFER,Vt.__webglFramebuffer);for(let Mn=0;Mn<De;Mn++)Mr&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,We.get(T).__webglTexture,Y,yt+Mn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,We.get(O).__webglTexture,Ee,on+Mn)),k.blitFramebuffer(Ge,rt,Ge+Le,rt+Ce,He,vt,He+Le,vt+Ce,k.DEPTH_BUFFER_BIT,k.NEAREST);Te.bindFramebuffer(k.READ_FRAMEBUFFER,null),Te.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(Y!==0||T.isRenderTargetTexture||We.has(T)){let pt=We.get(T),hn=We.get(O);Te.bindFramebuffer(k.READ_FRAMEBUFFER,N),Te.bindFramebuffer(k.DRAW_FRAMEBUFFER,W);for(let ri=0;ri<De;ri++)Mr?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,pt.__webglTexture,Y,yt+ri):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,pt.__webglTexture,Y),Xr?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,hn.__webglTexture,Ee,on+ri):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,hn.__webglTexture,Ee),Y!==0?k.blitFramebuffer(Ge,rt,Ge+Le,rt+Ce,He,vt,He+Le,vt+Ce,k.COLOR_BUFFER_BIT,k.NEAREST):Xr?k.copyTexSubImage3D(Be,Ee,He,vt,on+ri,Ge,rt,Le,Ce):k.copyTexSubImage2D(Be,Ee,He,vt,Ge,rt,Le,Ce);Te.bindFramebuffer(k.READ_FRAMEBUFFER,null),Te.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else Xr?T.isDataTexture||T.isData3DTexture?k.texSubImage3D(Be,Ee,He,vt,on,Le,Ce,De,Bt,In,Ot.data):O.isCompressedArrayTexture?k.compressedTexSubImage3D(Be,Ee,He,vt,on,Le,Ce,De,Bt,Ot.data):k.texSubImage3D(Be,Ee,He,vt,on,Le,Ce,De,Bt,In,Ot):T.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Ee,He,vt,Le,Ce,Bt,In,Ot.data):T.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Ee,He,vt,Ot.width,Ot.height,Bt,Ot.data):k.texSubImage2D(k.TEXTURE_2D,Ee,He,vt,Le,Ce,Bt,In,Ot);Te.pixelStorei(k.UNPACK_ROW_LENGTH,bn),Te.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Mt),Te.pixelStorei(k.UNPACK_SKIP_PIXELS,$r),Te.pixelStorei(k.UNPACK_SKIP_ROWS,Sn),Te.pixelStorei(k.UNPACK_SKIP_IMAGES,Ao),Ee===0&&O.generateMipmaps===!0&&O.mipmapsAutoUpdate===!0&&k.generateMipmap(Be),Te.unbindTexture()},this.initRenderTarget=function(T){We.get(T).__webglFramebuffer===void 0&&Je.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Je.setTextureCube(T,0):T.isData3DTexture?Je.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Je.setTexture2DArray(T,0):Je.setTexture2D(T,0),Te.unbindTexture()},this.resetState=function(){K=0,z=0,ue=null,Te.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return er}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=bt._getDrawingBufferColorSpace(e),t.unpackColorSpace=bt._getUnpackColorSpace()}};var Zh=0,s2=1,o2=new X,Iv=new Ll,Cm=new Ni,Lv=new X,Jh=new Nr,Kh=class{constructor(){this.tolerance=-1,this.faces=[],this.newFaces=[],this.assigned=new jh,this.unassigned=new jh,this.vertices=[]}setFromPoints(e){if(e.length>=4){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.vertices.push(new Rm(e[t]));this._compute()}return this}setFromObject(e){let t=[];return e.updateMatrixWorld(!0),e.traverse(function(i){let r=i.geometry;if(r!==void 0){let s=r.attributes.position;if(s!==void 0)for(let o=0,a=s.count;o<a;o++){let l=new X;l.fromBufferAttribute(s,o).applyMatrix4(i.matrixWorld),t.push(l)}}}),this.setFromPoints(t)}containsPoint(e){let t=this.faces;for(let i=0,r=t.length;i<r;i++)if(t[i].distanceToPoint(e)>this.tolerance)return!1;return!0}intersectRay(e,t){let i=this.faces,r=-1/0,s=1/0;for(let o=0,a=i.length;o<a;o++){let l=i[o],c=l.distanceToPoint(e.origin),h=l.normal.dot(e.direction);if(c>0&&h>=0)return null;let f=h!==0?-c/h:0;if(!(f<=0)&&(h>0?s=Math.min(f,s):r=Math.max(f,r),r>s))return null}return r!==-1/0?e.at(r,t):e.at(s,t),t}intersectsRay(e){return this.intersectRay(e,o2)!==null}makeEmpty(){return this.faces=[],this.vertices=[],this}_addVertexToFace(e,t){return e.face=t,t.outside===null?this.assigned.append(e):this.assigned.insertBefore(t.outside,e),t.outside=e,this}_removeVertexFromFace(e,t){return e===t.outside&&(e.next!==null&&e.next.face===t?t.outside=e.next:t.outside=null),this.assigned.remove(e),this}_removeAllVerticesFromFace(e){if(e.outside!==null){let t=e.outside,i=e.outside;for(;i.next!==null&&i.next.face===e;)i=i.next;return this.assigned.removeSubList(t,i),t.prev=i.next=null,e.outside=null,t}}_deleteFaceVertices(e,t){let i=this._removeAllVerticesFromFace(e);if(i!==void 0)if(t===void 0)this.unassigned.appendChain(i);else{let r=i;do{let s=r.next;t.distanceToPoint(r.point)>this.tolerance?this._addVertexToFace(r,t):this.unassigned.append(r),r=s}while(r!==null)}return this}_resolveUnassignedPoints(e){if(this.unassigned.isEmpty()===!1){let t=this.unassigned.first();do{let i=t.next,r=this.tolerance,s=null;for(let o=0;o<e.length;o++){let a=e[o];if(a.mark===Zh){let l=a.distanceToPoint(t.point);if(l>r&&(r=l,s=a),r>1e3*this.tolerance)break}}s!==null&&this._addVertexToFace(t,s),t=i}while(t!==null)}return this}_computeExtremes(){let e=new X,t=new X,i=[],r=[];for(let s=0;s<3;s++)i[s]=r[s]=this.vertices[0];e.copy(this.vertices[0].point),t.copy(this.vertices[0].point);for(let s=0,o=this.vertices.length;s<o;s++){let a=this.vertices[s],l=a.point;for(let c=0;c<3;c++)l.getComponent(c)<e.getComponent(c)&&(e.setComponent(c,l.getComponent(c)),i[c]=a);for(let c=0;c<3;c++)l.getComponent(c)>t.getComponent(c)&&(t.setComponent(c,l.getComponent(c)),r[c]=a)}return this.tolerance=3*Number.EPSILON*(Math.max(Math.abs(e.x),Math.abs(t.x))+Math.max(Math.abs(e.y),Math.abs(t.y))+Math.max(Math.abs(e.z),Math.abs(t.z))),{min:i,max:r}}_computeInitialHull(){let e=this.vertices,t=this._computeExtremes(),i=t.min,r=t.max,s=0,o=0;for(let d=0;d<3;d++){let p=r[d].point.getComponent(d)-i[d].point.getComponent(d);p>s&&(s=p,o=d)}let a=i[o],l=r[o],c,h;s=0,Iv.set(a.point,l.point);for(let d=0,p=this.vertices.length;d<p;d++){let m=e[d];if(m!==a&&m!==l){Iv.closestPointToPoint(m.point,!0,Lv);let x=Lv.distanceToSquared(m.point);x>s&&(s=x,c=m)}}s=-1,Cm.setFromCoplanarPoints(a.point,l.point,c.point);for(let d=0,p=this.vertices.length;d<p;d++){let m=e[d];if(m!==a&&m!==l&&m!==c){let x=Math.abs(Cm.distanceToPoint(m.point));x>s&&(s=x,h=m)}}let f=[];if(Cm.distanceToPoint(h.point)<0){f.push(yr.create(a,l,c),yr.create(h,l,a),yr.create(h,c,l),yr.create(h,a,c));for(let d=0;d<3;d++){let p=(d+1)%3;f[d+1].getEdge(2).setTwin(f[0].getEdge(p)),f[d+1].getEdge(1).setTwin(f[p+1].getEdge(0))}}else{f.push(yr.create(a,c,l),yr.create(h,a,l),yr.create(h,l,c),yr.create(h,c,a));for(let d=0;d<3;d++){let p=(d+1)%3;f[d+1].getEdge(2).setTwin(f[0].getEdge((3-d)%3)),f[d+1].getEdge(0).setTwin(f[p+1].getEdge(1))}}for(let d=0;d<4;d++)this.faces.push(f[d]);for(let d=0,p=e.length;d<p;d++){let m=e[d];if(m!==a&&m!==l&&m!==c&&m!==h){s=this.tolerance;let x=null;for(let _=0;_<4;_++){let g=this.faces[_].distanceToPoint(m.point);g>s&&(s=g,x=this.faces[_])}x!==null&&this._addVertexToFace(m,x)}}return this}_reindexFaces(){let e=[];for(let t=0;t<this.faces.length;t++){let i=this.faces[t];i.mark===Zh&&e.push(i)}return this.faces=e,this}_nextVertexToAdd(){if(this.assigned.isEmpty()===!1){let e,t=0,i=this.assigned.first().face,r=i.outside;do{let s=i.distanceToPoint(r.point);s>t&&(t=s,e=r),r=r.next}while(r!==null&&r.face===i);return e}}_computeHorizon(e,t,i,r){this._deleteFaceVertices(i),i.mark=s2;let s;t===null?s=t=i.getEdge(0):s=t.next;do{let o=s.twin,a=o.face;a.mark===Zh&&(a.distanceToPoint(e)>this.tolerance?this._computeHorizon(e,o,a,r):r.push(s)),s=s.next}while(s!==t);return this}_addAdjoiningFace(e,t){let i=yr.create(e,t.tail(),t.head());return this.faces.push(i),i.getEdge(-1).setTwin(t.twin),i.getEdge(0)}_addNewFaces(e,t){this.newFaces=[];let i=null,r=null;for(let s=0;s<t.length;s++){let o=t[s],a=this._addAdjoiningFace(e,o);i===null?i=a:a.next.setTwin(r),this.newFaces.push(a.face),r=a}return i.next.setTwin(r),this}_addVertexToHull(e){let t=[];return this.unassigned.clear(),this._removeVertexFromFace(e,e.face),this._computeHorizon(e.point,null,e.face,t),this._addNewFaces(e,t),this._resolveUnassignedPoints(this.newFaces),this}_cleanup(){return this.assigned.clear(),this.unassigned.clear(),this.newFaces=[],this}_compute(){let e;for(this._computeInitialHull();(e=this._nextVertexToAdd())!==void 0;)this._addVertexToHull(e);return this._reindexFaces(),this._cleanup(),this}},yr=class n{constructor(){this.normal=new X,this.midpoint=new X,this.area=0,this.constant=0,this.outside=null,this.mark=Zh,this.edge=null}static create(e,t,i){let r=new n,s=new Xl(e,r),o=new Xl(t,r),a=new Xl(i,r);return s.next=a.prev=o,o.next=s.prev=a,a.next=o.prev=s,r.edge=s,r.compute()}getEdge(e){let t=this.edge;for(;e>0;)t=t.next,e--;for(;e<0;)t=t.prev,e++;return t}compute(){let e=this.edge.tail(),t=this.edge.head(),i=this.edge.next.head();return Jh.set(e.point,t.point,i.point),Jh.getNormal(this.normal),Jh.getMidpoint(this.midpoint),this.area=Jh.getArea(),this.constant=this.normal.dot(this.midpoint),this}distanceToPoint(e){return this.normal.dot(e)-this.constant}},Xl=class{constructor(e,t){this.vertex=e,this.prev=null,this.next=null,this.twin=null,this.face=t}head(){return this.vertex}tail(){return this.prev?this.prev.vertex:null}length(){let e=this.head(),t=this.tail();return t!==null?t.point.distanceTo(e.point):-1}lengthSquared(){let e=this.head(),t=this.tail();return t!==null?t.point.distanceToSquared(e.point):-1}setTwin(e){return this.twin=e,e.twin=this,this}},Rm=class{constructor(e){this.point=e,this.prev=null,this.next=null,this.face=null}},jh=class{constructor(){this.head=null,this.tail=null}first(){return this.head}last(){return this.tail}clear(){return this.head=this.tail=null,this}insertBefore(e,t){return t.prev=e.prev,t.next=e,t.prev===null?this.head=t:t.prev.next=t,e.prev=t,this}insertAfter(e,t){return t.prev=e,t.next=e.next,t.next===null?this.tail=t:t.next.prev=t,e.next=t,this}append(e){return this.head===null?this.head=e:this.tail.next=e,e.prev=this.tail,e.next=null,this.tail=e,this}appendChain(e){for(this.head===null?this.head=e:this.tail.next=e,e.prev=this.tail;e.next!==null;)e=e.next;return this.tail=e,this}remove(e){return e.prev===null?this.head=e.next:e.prev.next=e.next,e.next===null?this.tail=e.prev:e.next.prev=e.prev,this}removeSubList(e,t){return e.prev===null?this.head=t.next:e.prev.next=t.next,t.next===null?this.tail=e.prev:t.next.prev=e.prev,this}isEmpty(){return this.head===null}};var Qh=()=>({position:[],normal:[],tone:[],lift:[],edges:[]}),Lm=.66;function a2(n){let e=n.map(Math.abs),t=e[0]>=e[1]&&e[0]>=e[2]?0:e[1]>=e[2]?1:2;return .5*(1+([5,1,4,2,3,0][2*t+(n[t]<0?1:0)]+1)/6)}function Ia(n,e,t,i,r=0){n.position.push(...e),n.normal.push(...t),n.tone.push(i),n.lift.push(r)}function xi(n,e,t,i=0,r=i){n.edges.push(...e,i,...t,r)}var vr=(n,e)=>[Math.cos(2*Math.PI*n/e),0,Math.sin(2*Math.PI*n/e)];function Dv(n,e,t){for(let i=0;i<8;++i){let[r,s,o]=[i&1?-1:1,i&2?-1:1,i&4?-1:1],a=r*s*o>0?1:Lm,l=(h,f)=>mi([r*(e-h-f),s*h,o*f],[0,1,0]),c=(h,f,d)=>{let p=r*s*o>0?[h,f,d].reverse():[h,f,d];for(let m of p)Ia(n,m,m,a,t?s:0)};for(let h=0;h<e;++h)for(let f=0;f<e-h;++f)c(l(h,f),l(h,f+1),l(h+1,f)),h+f+2<=e&&c(l(h+1,f),l(h,f+1),l(h+1,f+1))}}function l2(n){let e=Qh();Dv(e,n,!1);let t=6*n;for(let i=0;i<t;++i){let[r,s]=[vr(i,t),vr(i+1,t)];xi(e,r,s),xi(e,[r[0],r[2],0],[s[0],s[2],0]),xi(e,[0,r[0],r[2]],[0,s[0],s[2]])}return e}function c2(n){let e=Qh();Dv(e,n,!0);let t=8*n;for(let i=0;i<t;++i){let[r,s]=[vr(i,t),vr(i+1,t)],o=Math.floor(4*i/t)%2?Lm:1;for(let[a,l]of[[r,-1],[r,1],[s,1],[r,-1],[s,1],[s,-1]])Ia(e,a,a,o,l);xi(e,r,s,1),xi(e,r,s,-1)}for(let i=0;i<24;++i){let[r,s]=[vr(i,48),vr(i+1,48)];for(let o of[1,-1])xi(e,[r[0],o*r[2],0],[s[0],o*s[2],0],o),xi(e,[0,o*r[2],r[0]],[0,o*s[2],s[0]],o)}for(let i=0;i<4;++i)xi(e,vr(i,4),vr(i,4),-1,1);return e}function Pm(n,e,t,i){let r=Qh(),s=(1-i)/(t-e);for(let o=0;o<n;++o){let a=Math.floor(4*o/n)%2?Lm:1,[l,c]=[vr(o,n),vr(o+1,n)],h=(d,p,m)=>[p*d[0],m,p*d[2]],f=d=>mi([d[0],s,d[2]],d);if(t>e)for(let[d,p]of[[l,e],[l,t],[c,t],[l,e],[c,t],[c,e]])Ia(r,h(d,p===t?i:1,p),f(d),a);for(let d of[[0,e,0],h(l,1,e),h(c,1,e)])Ia(r,d,[0,-1,0],.8*a);if(xi(r,h(l,1,e),h(c,1,e)),i>0){for(let d of[[0,t,0],h(c,i,t),h(l,i,t)])Ia(r,d,[0,1,0],.9*a);xi(r,h(l,i,t),h(c,i,t))}}for(let o=0;o<4;++o){let a=vr(o,4);xi(r,[a[0],e,a[2]],[i*a[0],t,i*a[2]])}return r}function u2(n){let e=new Map,t=i=>i.map(r=>Math.fround(r)).join();for(let i=0;i<n.position.length;i+=9){let r=[0,1,2].map(o=>n.position.slice(i+3*o,i+3*o+3)),s=mi(Kr(mt(r[1],r[0]),mt(r[2],r[0])),[0,1,0]);for(let o=0;o<3;++o){let[a,l]=[r[o],r[(o+1)%3]],c=t(a)<t(l)?`${t(a)} ${t(l)}`:`${t(l)} ${t(a)}`,h=e.get(c);h?(++h.count,xt(s,h.n)<Math.cos(Math.PI/9)&&!h.drawn&&(h.drawn=!0,xi(n,a,l))):e.set(c,{n:s,drawn:!1,a,b:l,count:1})}}for(let i of e.values())i.count===1&&xi(n,i.a,i.b)}function ed(n){let e=Qh();for(let[t,i,r]of n){let s=mi(Kr(mt(i,t),mt(r,t)),[0,0,0]);if(Tt(s)!==0)for(let o of[t,i,r])Ia(e,o,s,a2(s))}return u2(e),e}function Nv(n){let e=n.filter(i=>i.every(Number.isFinite)),t=[];if(e.length<4)return t;for(let i of new Kh().setFromPoints(e.map(r=>new X(...r))).faces){let r=[],s=i.edge;do{let o=s.head().point;r.push([o.x,o.y,o.z]),s=s.next}while(s!==i.edge);for(let o=2;o<r.length;++o)t.push([r[0],r[o-1],r[o]])}return t}function Im(){let n=[];for(let e=0;e<3;++e)for(let t of[1,-1]){let i=(r,s)=>{let o=[0,0,0];return o[e]=t,o[(e+1)%3]=r,o[(e+2)%3]=s*t,o};n.push([i(-1,-1),i(1,-1),i(1,1)],[i(-1,-1),i(1,1),i(-1,1)])}return ed(n)}function h2(){let n=Im();n.position=n.position.map(e=>.3*e),n.edges=[];for(let e=0;e<3;++e){let t=Im();for(let s=0;s<t.position.length;++s){let o=s%3===e,a=t.position[s];t.position[s]=o?a>0?1:-.5:.09*a}n.position.push(...t.position),n.normal.push(...t.normal),n.tone.push(...t.tone.map(s=>[1,.8,.6][e]*(.5+.5*s))),n.lift.push(...t.lift);let[i,r]=[[0,0,0],[0,0,0]];i[e]=-.5,r[e]=1,xi(n,i,r)}return n}function Fv(n,e){let t=e<=60?8:e<=300?5:3,i=4*t;return{sphere:()=>l2(t),box:Im,capsule:()=>c2(t),cylinder:()=>Pm(i,-1,1,1),cone:()=>Pm(i,-.25,.75,0),disc:()=>Pm(i,0,0,1),cross:h2}[n]()}function Dm(n){return n.reduce((e,t)=>e.map((i,r)=>Math.max(i,Math.abs(t[r]))),it([1,1,1],0))}var d2=[1,0,0,0],Uv=-1,La=n=>[n,n,n];function kv(n,e){let t={molds:new Map,pieces:[],radius:[]},i=n.body.length,r=(a,l,c,h,f,d)=>{t.molds.has(l)||t.molds.set(l,Fv(l,i)),t.pieces.push({body:a,mold:l,size:c,half:h,position:f,orientation:d})},s=(a,l,c,h,f,d)=>{t.molds.has(l)||t.molds.set(l,c()),t.molds.get(l).position.length===0?r(a,"cross",[...La(Tt(h)||e),Uv],h,f,d):t.pieces.push({body:a,mold:l,size:[1,1,1,0],half:h,position:f,orientation:d})},o=(a,l,c,h)=>{if(!l)return r(a,"cross",[...La(e),Uv],La(e),c,h);switch(l.type){case"sphere":return r(a,"sphere",[...La(l.radius),0],La(l.radius),c,h);case"box":return r(a,"box",[...l.half_extents,0],l.half_extents,c,h);case"capsule":{let{radius:f,length:d}=l;return r(a,"capsule",[f,f,f,d/2],[f,f+d/2,f],c,h)}case"cylinder":{let{radius:f,length:d}=l;return r(a,"cylinder",[f,d/2,f,0],[f,d/2,f],c,h)}case"cone":{let{radius:f,length:d}=l;return r(a,"cone",[f,d,f,0],[f,.75*d,f],c,h)}case"rod":{let f=.012*l.length;return r(a,"cylinder",[f,l.length/2,f,0],[f,l.length/2,f],c,h)}case"disc":return r(a,"disc",[...La(l.radius),0],[l.radius,.02*l.radius,l.radius],c,h);case"hull":return s(a,`hull ${l.vertices.join()}`,()=>ed(Nv(l.vertices)),Dm(l.vertices),c,h);case"mesh":{let f=p=>l.vertices[p]??[0,0,0],d=()=>ed(l.faces.map(([p,m,x])=>[f(p),f(m),f(x)]));return s(a,`mesh ${l.vertices.join()} ${l.faces.join()}`,d,Dm(l.vertices),c,h)}case"compound":for(let f of l.parts)o(a,f.shape,je(c,Jt(h,f.position)),Rs(h,f.orientation))}};n.body.forEach((a,l)=>o(l,Zo(a),[0,0,0],d2)),t.radius=n.body.map(()=>0);for(let a of t.pieces)t.radius[a.body]=Math.max(t.radius[a.body],Tt(a.position)+Tt(a.half));return t}function Ov(n){let e=new Map;for(let t of n.pieces){let i=e.get(t.mold);i?i.push(t):e.set(t.mold,[t])}return e}function Bv(n,e){let t=Math.floor(n.length/(3*e)),i=Math.max(1,Math.ceil(t*e/15e4)),r=Math.floor((t-1)/i)+1;return{source:n,positions:new Float32Array(3*e*r),bodies:e,frames:r,every:i,filled:0,upTo:0}}function Vv(n,e){let{source:t,positions:i,bodies:r,every:s}=n;for(n.upTo=Math.max(0,Math.min(Math.floor(e/s),n.frames-1));n.filled<=n.upTo;++n.filled){let o=n.filled;for(let a=0;a<r;++a){let l=3*(o*s*r+a),c=3*(o*r+a),h=Number.isFinite(t[l]+t[l+1]+t[l+2]);if(h&&o>0&&Number.isNaN(i[c-3*r]))for(let f=c-3*r;f>=0;f-=3*r)i.set(t.subarray(l,l+3),f);for(let f=0;f<3;++f)i[c+f]=h?t[l+f]:o>0?i[c+f-3*r]:NaN}}}var td=class{constructor(e){this.count=e;this.position=new Float64Array(3*e),this.orientation=new Float64Array(4*e),this.hidden=new Uint8Array(e)}count;position;orientation;hidden;shown=!1;version=0;set(e){if(++this.version,this.shown=e!==null,!!e)for(let t=0;t<this.count;++t){let i=0;for(let o=3*t;o<3*t+3;++o)i+=this.position[o]=e.position[o]??NaN;let r=0;for(let o=4*t;o<4*t+4;++o)r+=(this.orientation[o]=e.orientation[o]??NaN)**2;let s=1/Math.sqrt(r);this.hidden[t]=Number.isFinite(i)&&Math.abs(i)<1e30&&Number.isFinite(s)?0:1;for(let o=4*t;o<4*t+4;++o)this.orientation[o]*=s}}at(e){return[this.position[3*e],this.position[3*e+1],this.position[3*e+2]]}turn(e){let t=this.orientation;return[t[4*e],t[4*e+1],t[4*e+2],t[4*e+3]]}},ql=class{constructor(e,t,i){this.scene=e;this.theme=t;this.bounds=Ko(e,i),this.extent=Math.max(Tt(mt(this.bounds.max,this.bounds.min)),1e-9),this.solids=kv(e,.035*this.extent);let r=[...this.solids.radius].sort((s,o)=>s-o);this.typical=r[r.length>>1]??this.extent,this.colours=e.body.map(yx),this.joined=new Jc(e,this.extent),this.layers={bodies:new td(e.body.length),ghost:new td(e.body.length)},this.layers.bodies.set({position:e.body.flatMap(s=>s.position),orientation:e.body.flatMap(s=>s.orientation)})}scene;theme;bounds;extent;typical;solids;colours;layers;trails={bodies:null,ghost:null};fixed=new Qo;links=new Qo;marks=new Qo;time=0;arrows=[];pulls=[];linksShown=!0;grid=0;planesFor=null;contacts=[];largestImpulse=0;joined;setEye(e,t){let i=Fx(this.scene,e),{theme:r}=this,s=this.planesFor;s?.theme===r&&s.held===t&&i.every((o,a)=>o===s.open[a])||(this.planesFor={theme:r,held:t,open:i},this.grid=hp(Tt(mt(t.max,t.min))),this.fixed.clear(),Ux(this.fixed,this.scene,t,r,i))}relink(){this.links.clear(),this.marks.clear();let e=this.layers.bodies.shown?this.layers.bodies:this.layers.ghost;this.linksShown&&e.shown&&this.joined.draw(this,e),Lx(this,this.contacts,this.largestImpulse),Ix(this,this.arrows),Dx(this,this.pulls)}setContacts(e,t){if(this.contacts=e,t!==void 0)this.largestImpulse=t;else for(let{impulse:i}of e)Number.isFinite(i)&&(this.largestImpulse=Math.max(this.largestImpulse,i))}setTrail(e,t,i,r){let s=this.trails[e];if(!t||i<1||t.length<6*i){this.trails[e]=null;return}let o=s?.source===t&&s.bodies===i?s:Bv(t,i);Vv(o,r),this.trails[e]=o}lost(){let{shown:e,hidden:t}=this.layers.bodies;return e?this.scene.body.filter((i,r)=>t[r]).map(i=>i.name):[]}};function zv(n,e){let t=e.turn(n.body);return{centre:je(e.at(n.body),Jt(t,n.position)),turn:Rs(t,n.orientation)}}function Nm({centre:n,turn:e},t,i,r,s,o){let[a,l,c,h]=t.size;return je(n,Jt(e,[a*i,l*r+h*o,c*s]))}var Fm=(n,e,t)=>Ri(n.map(i=>i*e*t)),f2=(n,e)=>.62+.38*(-.34*xt(e,n.right)+.63*xt(e,n.up)+.68*xt(e,n.back));function Hv(n,e){let t=[],i=n.layers.bodies,r=1/fr(e);for(let s of n.solids.pieces){if(i.hidden[s.body])continue;let o=zv(s,i),a=n.colours[s.body],{x:l,y:c,depth:h}=Pi(e,o.centre),f=n.solids.molds.get(s.mold),d=r*Math.max(...s.half);d<2.5?t.push({depth:h,draw:p=>Gv(p,l,c,2.5,Ri(a))}):s.mold==="sphere"?t.push({depth:h,draw:p=>p2(p,e,f,s,o,a,l,c,d)}):m2(t,e,f,s,o,a)}return t}function Gv(n,e,t,i,r){n.fillStyle=r,n.beginPath(),n.arc(e,t,i,0,2*Math.PI),n.fill()}function p2(n,e,t,i,r,s,o,a,l){Gv(n,o,a,l,Fm(s,.95,.85)),!(l<5)&&(n.strokeStyle=Fm(s,.5,.9),n.lineWidth=Math.min(2,l/6),n.beginPath(),Wv(n,e,t,i,r,!0),n.stroke())}function Wv(n,e,{edges:t},i,r,s){for(let o=0;o<t.length;o+=8){let a=Nm(r,i,t[o],t[o+1],t[o+2],t[o+3]),l=Nm(r,i,t[o+4],t[o+5],t[o+6],t[o+7]);if(s&&xt(mt(je(a,l),je(r.centre,r.centre)),e.back)<0)continue;let[c,h]=[Pi(e,a),Pi(e,l)];n.moveTo(c.x,c.y),n.lineTo(h.x,h.y)}}function m2(n,e,t,i,r,s){let[o,a,l]=i.size,c=Math.max(...i.half)>10*fr(e);for(let h=0;h<t.tone.length;h+=3){let f=Jt(r.turn,[t.normal[3*h]/(o||1),t.normal[3*h+1]/(a||1),t.normal[3*h+2]/(l||1)]),d=Math.hypot(...f)||1,p=[0,1,2].map(v=>{let E=3*(h+v);return Pi(e,Nm(r,i,t.position[E],t.position[E+1],t.position[E+2],t.lift[h+v]))}),[m,x,_]=p;if((x.x-m.x)*(_.y-m.y)-(x.y-m.y)*(_.x-m.x)>=0)continue;let g=Fm(s,t.tone[h],f2(e,[f[0]/d,f[1]/d,f[2]/d]));n.push({depth:(m.depth+x.depth+_.depth)/3,draw:v=>{v.fillStyle=g,v.beginPath();for(let{x:E,y:M}of p)v.lineTo(E,M);v.closePath(),v.fill(),c&&(v.strokeStyle=g,v.lineWidth=.7,v.stroke())}})}}function $v(n,e,t){let i=n.layers.ghost;t.strokeStyle=Ri(n.theme.ink),t.lineWidth=1,t.setLineDash([4,3]),t.beginPath();for(let r of n.solids.pieces){if(i.hidden[r.body])continue;let s=zv(r,i),{x:o,y:a}=Pi(e,s.centre);if(r.mold==="sphere"){let l=Math.max(r.half[0]/fr(e),4);t.moveTo(o+l,a),t.arc(o,a,l,0,2*Math.PI)}else Wv(t,e,n.solids.molds.get(r.mold),r,s,!1)}t.stroke(),t.setLineDash([])}var Xv=n=>Math.min(Math.max(Math.trunc((n- -5)/.25),0),40);function qv(n,e,t,i){if(n.mode!=="step")return n.level+n.wave*Math.sin(e-n.speed*i);let[r,s]=[Xv(e),Xv(t)];return n.level+n.wave/2*(Math.sin(n.speed*i+r)+Math.sin(r*s/2))}function Yv(n,e){let t=new Float32Array(4*(e+1)**2),i=new Uint32Array(6*e*e),r=1.3*Math.max(n.max[0]-n.min[0],n.max[2]-n.min[2],.6*(n.max[1]-n.min[1])),s=(n.min[0]+n.max[0]-r)/2,o=(n.min[2]+n.max[2]-r)/2;for(let a=0;a<=e;++a)for(let l=0;l<=e;++l)t.set([s+r*a/e,o+r*l/e,0,0],4*(a*(e+1)+l));for(let a=0;a<e;++a)for(let l=0;l<e;++l){let c=a*(e+1)+l;i.set([c,c+1,c+e+2,c,c+e+2,c+e+1],6*(a*e+l))}return{place:t,index:i}}function Jv(){let e=new Float32Array(79376),t=new Uint32Array(6*4961),i=0,r=(...s)=>{s.forEach((o,a)=>e.set(o,16*i+4*a)),t.set([4*i,4*i+1,4*i+2,4*i,4*i+2,4*i+3],6*i),++i};for(let s=0;s<41;++s)for(let o=0;o<41;++o){let[a,l]=[-5+.25*s,-5+.25*o],[c,h]=[a+.25,l+.25];r([a,l,s,o],[a,h,s,o],[c,h,s,o],[c,l,s,o]),s+1<41&&r([c,l,s,o],[c,h,s,o],[c,h,s+1,o],[c,l,s+1,o]),o+1<41&&r([a,h,s,o],[c,h,s,o],[c,h,s,o+1],[a,h,s,o+1])}return{place:e,index:t}}var g2=["bodies","ghost"],nd=class{constructor(e){this.canvas=e;this.context=e.getContext("2d",{willReadFrequently:!0})}canvas;webgl=!1;lost=!1;onChange=null;picture=null;context;show(e){this.picture=e}draw(e){let t=this.picture;if(!t)return;let{context:i,canvas:r}=this,[s,o]=[Math.max(1,Math.round(e.width*e.ratio)),Math.max(1,Math.round(e.height*e.ratio))];(r.width!==s||r.height!==o)&&([r.width,r.height]=[s,o]),i.setTransform(e.ratio,0,0,e.ratio,0,0),i.fillStyle=Ri(t.theme.ground),i.fillRect(0,0,e.width,e.height),i.lineCap=i.lineJoin="round";for(let c=0;c<t.fixed.count;++c)this.segment(e,t.fixed,c);for(let c of g2)this.trail(e,t,t.trails[c],c==="ghost");let a=t.layers.bodies.shown?Hv(t,e):[],{links:l}=t;for(let c=0;c<l.count;++c)a.push({depth:this.depth(e,l,c),draw:()=>this.segment(e,l,c)});this.water(a,e,t),a.sort((c,h)=>h.depth-c.depth);for(let c of a)c.draw(i);t.layers.ghost.shown&&$v(t,e,i);for(let c=0;c<t.marks.count;++c)this.segment(e,t.marks,c)}depth(e,{data:t},i){let r=i*12,s=[t[r]+t[r+3],t[r+1]+t[r+4],t[r+2]+t[r+5]];return Pi(e,[s[0]/2,s[1]/2,s[2]/2]).depth}segment(e,{data:t},i){let r=this.context,s=i*12,o=Pi(e,[t[s],t[s+1],t[s+2]]),a=Pi(e,[t[s+3],t[s+4],t[s+5]]),l=Ri([t[s+6],t[s+7],t[s+8]]),[c,h,f]=[t[s+9],t[s+10],t[s+11]],d=Math.hypot(a.x-o.x,a.y-o.y);if(r.fillStyle=r.strokeStyle=l,r.beginPath(),f===2)r.arc(o.x,o.y,c/2,0,2*Math.PI),r.fill();else if(c!==h){let[p,m]=d>0?[(a.y-o.y)*c/2/d,(o.x-a.x)*c/2/d]:[0,0];r.moveTo(o.x+p,o.y+m),r.lineTo(o.x-p,o.y-m),r.lineTo(a.x,a.y),r.fill()}else r.setLineDash(f===1?[5,4]:[]),r.lineWidth=c,r.moveTo(o.x,o.y),r.lineTo(a.x,a.y),r.stroke(),r.setLineDash([])}trail(e,t,i,r){if(!i)return;let s=this.context,o=i.upTo;s.lineWidth=1.5,s.setLineDash(r?[5,4]:[]);for(let a=0;a<i.bodies;++a){s.strokeStyle=Ri(t.colours[a]??t.theme.ink),s.beginPath();for(let l=0;l<=o;++l){let c=3*(l*i.bodies+a),{x:h,y:f}=Pi(e,i.positions.subarray(c,c+3));s.lineTo(h,f)}s.stroke()}s.setLineDash([])}water(e,t,{scene:i,bounds:r,theme:s,time:o}){let a=Ri(Lr([.1,.4,.8],s.ink,.1));for(let l of i.water){let c=1.3*Math.max(r.max[0]-r.min[0],r.max[2]-r.min[2]),[h,f]=[(r.min[0]+r.max[0]-c)/2,(r.min[2]+r.max[2]-c)/2];for(let d=0;d<=16;++d){let p=f+c*d/16,m=x=>{x.strokeStyle=a,x.lineWidth=1,x.beginPath();for(let _=0;_<=120;++_){let g=h+c*_/120,v=Pi(t,[g,qv(l,g,p,o),p]);x.lineTo(v.x,v.y)}x.stroke()};e.push({depth:Pi(t,[h+c/2,l.level,p]).depth,draw:m})}}}dispose(){this.picture=null}};function _2(n){let e={position:[],normal:[],tone:[],lift:[],index:[]},t=new Map;for(let i=0;i<n.tone.length;++i){let r=n.position.slice(3*i,3*i+3),s=n.normal.slice(3*i,3*i+3),o=`${r} ${s} ${n.tone[i]} ${n.lift[i]}`,a=t.get(o);a===void 0&&(a=t.size,t.set(o,a),e.position.push(...r),e.normal.push(...s),e.tone.push(n.tone[i]),e.lift.push(n.lift[i])),e.index.push(a)}return e}var id=class{constructor(e,t,i,r,s){this.pieces=t;let o=t.length;this.center=new Os(new Float32Array(4*o),4).setUsage(yo),this.turn=new Os(new Float32Array(4*o),4).setUsage(yo);let a=new Os(new Float32Array(t.flatMap(_=>_.size)),4),l=new Os(new Float32Array(t.flatMap(_=>i[_.body])),3),c=(_,g)=>{let v=new po;return v.instanceCount=o,v.setAttribute("position",new pn(new Float32Array(_),3)),v.setAttribute("lift",new pn(new Float32Array(g),1)),v.setAttribute("center",this.center),v.setAttribute("turn",this.turn),v.setAttribute("size",a),v.setAttribute("color",l),v},{position:h,normal:f,tone:d,lift:p,index:m}=_2(e),x=c(h,p);if(x.setAttribute("normal",new pn(new Float32Array(f),3)),x.setAttribute("tone",new pn(new Float32Array(d),1)),x.setIndex(m),this.drawn.push(new Jn(x,r)),s&&e.edges.length>0){let _=e.edges.filter((g,v)=>v%4<3);this.drawn.push(new Al(c(_,e.edges.filter((g,v)=>v%4===3)),s))}for(let _ of this.drawn)_.frustumCulled=_.matrixAutoUpdate=!1}pieces;drawn=[];center;turn;place(e,t,i){let r=this.center.array,s=this.turn.array;for(let o=0;o<this.pieces.length;++o){let{body:a,position:l,orientation:c}=this.pieces[o],h=4*o;if(r[h+3]=i[a]?0:1,i[a])continue;let f=t[4*a],d=t[4*a+1],p=t[4*a+2],m=t[4*a+3],x=p*l[2]-m*l[1]+f*l[0],_=m*l[0]-d*l[2]+f*l[1],g=d*l[1]-p*l[0]+f*l[2];r[h]=e[3*a]+l[0]+2*(p*g-m*_),r[h+1]=e[3*a+1]+l[1]+2*(m*x-d*g),r[h+2]=e[3*a+2]+l[2]+2*(d*_-p*x),s[h]=f*c[0]-d*c[1]-p*c[2]-m*c[3],s[h+1]=f*c[1]+d*c[0]+p*c[3]-m*c[2],s[h+2]=f*c[2]-d*c[3]+p*c[0]+m*c[1],s[h+3]=f*c[3]+d*c[2]-p*c[1]+m*c[0]}this.center.needsUpdate=this.turn.needsUpdate=!0}dispose(){for(let e of this.drawn)e.geometry.dispose()}};var rd=`
precision highp float;
uniform mat4 view, projection;
`,Zv=`
${rd}
uniform float grow;      // part by which a ghost is larger than a body: equal poses must not fight for depth
uniform float smallest;  // least half extent, as a part of the distance: small bodies stay in sight
in vec3 position;
in float lift;
in vec4 center;
in vec4 turn;
in vec4 size;
in vec3 color;
vec3 rotated(vec3 v) { return v + 2.0 * cross(turn.yzw, cross(turn.yzw, v) + turn.x * v); }
vec4 placed() {
  float depth = max(-(view * vec4(center.xyz, 1.0)).z, 0.0);
  float half_extent = max(max(size.x, size.z), size.y + max(size.w, 0.0));
  float least = size.w < 0.0 ? 2.5 * smallest : smallest;  // crosses are thin
  float k = max(1.0 + grow, least * depth / max(half_extent, 1e-30));
  vec3 local = position * size.xyz + vec3(0.0, lift * size.w, 0.0);
  return center.w > 0.0 ? view * vec4(center.xyz + rotated(k * local), 1.0) : vec4(0.0, 0.0, 1e30, 1.0);
}
`,Um=`
${Zv}
in vec3 normal;
in float tone;
out vec3 shade;
out float rim;
void main() {
  vec4 p = placed();
  gl_Position = projection * p;
  vec3 n = normalize(mat3(view) * rotated(normalize(normal / max(size.xyz, vec3(1e-30)))));
  float light = 0.62 + 0.38 * dot(n, normalize(vec3(-0.35, 0.65, 0.7)));
  shade = color * tone * light;
  rim = 1.0 - abs(dot(n, normalize(p.xyz)));
}
`,Kv=`
precision highp float;
in vec3 shade;
in float rim;
out vec4 pixel;
void main() { pixel = vec4(shade, 1.0); }
`,jv=`
precision highp float;
uniform vec3 ink;
uniform float ratio;
in vec3 shade;
in float rim;
out vec4 pixel;
void main() {
  float stripe = step(0.5, fract((gl_FragCoord.x - gl_FragCoord.y) / (7.0 * ratio)));
  pixel = vec4(mix(shade, ink, 0.55), 0.08 + 0.2 * stripe + 0.45 * smoothstep(0.6, 0.95, rim));
}
`,Qv=`
${Zv}
void main() { gl_Position = projection * placed(); }
`,eb=`
precision highp float;
uniform vec3 ink;
uniform float ratio;
out vec4 pixel;
void main() {
  if (fract((gl_FragCoord.x + gl_FragCoord.y) / (8.0 * ratio)) > 0.6) discard;
  pixel = vec4(ink, 0.9);
}
`,tb=`
uniform vec2 pixels;  // of the drawing buffer
uniform float ratio, near, bias;
out vec3 shade;
flat out float broken;
out vec2 spot;  // within a dot: -1 \u2026 1 each way
void draw(vec3 a, vec3 b, vec2 widths, vec2 corner) {
  vec4 from = view * vec4(a, 1.0), to = view * vec4(b, 1.0);
  // What lies behind the camera is cut off at the near plane.
  if (from.z > -near && to.z > -near) { gl_Position = vec4(0.0, 0.0, 2.0, 1.0); return; }
  if (from.z > -near) from = mix(to, from, (-near - to.z) / (from.z - to.z));
  if (to.z > -near) to = mix(from, to, (-near - from.z) / (to.z - from.z));
  vec4 p = projection * from, q = projection * to;
  vec2 along = (q.xy / q.w - p.xy / p.w) * pixels;
  float l = length(along);
  along = l > 1e-3 ? along / l : vec2(1.0, 0.0);
  float width = mix(widths.x, widths.y, corner.x) * ratio;
  if (corner.x < 0.5) width = max(width, 1.0);
  float cap = 0.5 * min(widths.x, widths.y) * ratio;
  vec2 shift = 0.5 * width * corner.y * vec2(-along.y, along.x) + (2.0 * corner.x - 1.0) * cap * along;
  spot = vec2(2.0 * corner.x - 1.0, corner.y);
  vec4 c = corner.x < 0.5 ? p : q;
  gl_Position = vec4(c.xy + 2.0 * shift / pixels * c.w, c.z - bias * c.w, c.w);
}
`,km=`
${rd}
${tb}
in vec3 position;  // which end, which side
in vec3 from, to, color;
in vec2 widths;
in float pattern;
void main() {
  shade = color;
  broken = pattern;
  draw(from, to, widths, position.xy);
}
`,nb=`
${rd}
${tb}
in vec3 position;  // which end, which side
in vec3 from, to;
uniform int bodies;
uniform float dashes;
uniform sampler2D colors;
void main() {
  int body = gl_InstanceID % bodies;
  shade = texelFetch(colors, ivec2(body % 1024, body / 1024), 0).rgb;
  broken = dashes;
  draw(from, to, vec2(1.5), position.xy);
}
`,sd=`
precision highp float;
uniform float ratio;
in vec3 shade;
flat in float broken;
in vec2 spot;
out vec4 pixel;
void main() {
  if (broken > 1.5 && dot(spot, spot) > 1.0) discard;
  float dash = fract((gl_FragCoord.x + gl_FragCoord.y) / (9.0 * ratio));
  if (broken > 0.5 && broken < 1.5 && dash > 0.55) discard;
  pixel = vec4(shade, 1.0);
}
`,ib=`
${rd}
uniform float level, wave, speed, time;
uniform bool cells;
in vec4 place;  // x, z, and the indices i, j of the cell
out float height;
void main() {
  float y = cells ? 0.5 * wave * (sin(speed * time + place.z) + sin(0.5 * place.z * place.w))
                  : wave * sin(place.x - speed * time);
  height = wave > 0.0 ? y / wave : 0.0;
  gl_Position = projection * view * vec4(place.x, level + y, place.y, 1.0);
}
`,rb=`
precision highp float;
uniform float alpha;
in float height;
out vec4 pixel;
void main() { pixel = vec4(0.08, 0.32 + 0.1 * height, 0.68 + 0.2 * height, alpha); }
`;function od(){let n=new po;return n.setAttribute("position",new pn(new Float32Array([0,-1,0,1,-1,0,1,1,0,0,-1,0,1,1,0,0,1,0]),3)),n}var Da=class{constructor(e,t,i){this.lines=e;this.drawn=new Jn(od(),t),this.drawn.frustumCulled=this.drawn.matrixAutoUpdate=!1,this.drawn.renderOrder=i}lines;drawn;version=-1;buffer=null;sync(){if(this.version===this.lines.version)return;this.version=this.lines.version,this.buffer?.array!==this.lines.data&&this.attach();let e=this.drawn.geometry;e.instanceCount=this.lines.count,this.drawn.visible=this.lines.count>0,this.buffer.clearUpdateRanges(),this.buffer.addUpdateRange(0,this.lines.count*12),this.buffer.needsUpdate=!0}attach(){let e=this.drawn.material;this.drawn.geometry.dispose();let t=od();this.buffer=new wa(this.lines.data,12),this.buffer.setUsage(yo);let i=(r,s,o)=>{t.setAttribute(r,new uo(this.buffer,s,o))};i("from",3,0),i("to",3,3),i("color",3,6),i("widths",2,9),i("pattern",1,11),this.drawn.geometry=t,this.drawn.material=e}dispose(){this.drawn.geometry.dispose()}},Om=1024;function sb(n){let e=Math.max(1,Math.ceil(n.length/Om)),t=new Float32Array(4*Om*e);n.forEach((r,s)=>t.set([...r,1],4*s));let i=new va(t,Om,e,zi,Vi);return i.needsUpdate=!0,i}var ad=class{constructor(e){this.material=e;this.drawn=new Jn(od(),e),this.drawn.frustumCulled=this.drawn.matrixAutoUpdate=!1,this.drawn.renderOrder=2,this.drawn.visible=!1}material;drawn;trail=null;buffer=null;sent=0;sync(e){if(this.drawn.visible=e!==null&&e.upTo>0,!!e){if(this.trail!==e&&this.attach(e),this.sent<e.filled){let t=3*e.bodies;this.buffer.clearUpdateRanges(),this.buffer.addUpdateRange(this.sent*t,(e.filled-this.sent)*t),this.buffer.needsUpdate=!0,this.sent=e.filled}this.drawn.geometry.instanceCount=e.bodies*e.upTo}}attach(e){this.trail=e,this.sent=0,this.drawn.geometry.dispose();let t=od();this.buffer=new wa(e.positions,3),this.buffer.setUsage(yo),t.setAttribute("from",new uo(this.buffer,3,0));let i=3*e.bodies;t.setAttribute("to",new uo(this.buffer,3,i)),this.drawn.geometry=t,this.material.uniforms.bodies.value=e.bodies}dispose(){this.drawn.geometry.dispose()}};function ob(n,e,t){let i=new tr,{place:r,index:s}=n.mode==="step"?Jv():Yv(e,80);i.setAttribute("place",new pn(r,4)),i.setIndex(new pn(s,1));let o=new Jn(i,t);return o.frustumCulled=o.matrixAutoUpdate=!1,o}bt.enabled=!1;var ld=["bodies","ghost"],cd=class{constructor(e,t){this.canvas=e;this.renderer=new Xh({canvas:e,context:t}),this.renderer.outputColorSpace=lo,this.renderer.sortObjects=!0,this.scene.matrixWorldAutoUpdate=!1,this.camera.matrixWorldAutoUpdate=!1,e.addEventListener("webglcontextlost",this.onLost),e.addEventListener("webglcontextrestored",this.onRestored)}canvas;webgl=!0;lost=!1;onChange=null;renderer;camera=new fo;common={view:{value:new Zt},projection:{value:new Zt},pixels:{value:new Et(1,1)},ratio:{value:1},near:{value:.1},smallest:{value:0},ink:{value:new X}};materials={body:this.material(Um,Kv,{grow:0},{}),ghost:this.material(Um,jv,{grow:.008},{transparent:!0,depthWrite:!1}),edge:this.material(Qv,eb,{grow:.012},{transparent:!0,depthWrite:!1}),line:this.material(km,sd,{bias:1e-4},{}),mark:this.material(km,sd,{bias:0},{depthTest:!1,transparent:!0})};picture=null;scene=new Sl;batches={bodies:[],ghost:[]};placed={bodies:-1,ghost:-1};strips=[];trails=null;waters=[];colours=null;onLost=e=>{e.preventDefault(),this.lost=!0,this.clear();for(let t of Object.values(this.materials))t.dispose();this.onChange?.()};onRestored=()=>{this.lost=!1,this.picture&&this.show(this.picture),this.onChange?.()};material(e,t,i,r){let s={...this.common};for(let[o,a]of Object.entries(i))s[o]={value:a};return new Sa({glslVersion:zl,vertexShader:e,fragmentShader:t,uniforms:s,...r})}show(e){if(this.clear(),this.picture=e,this.lost)return;let t=e.colours,i=Ov(e.solids);for(let a of ld){let l=a==="ghost",c=l?this.materials.ghost:this.materials.body;for(let[h,f]of i){let d=new id(e.solids.molds.get(h),f,t,c,l?this.materials.edge:null);for(let p of d.drawn)p.renderOrder=l?6:0,this.scene.add(p);this.batches[a].push(d)}}this.placed={bodies:-1,ghost:-1};let{line:r,mark:s}=this.materials;this.strips=[new Da(e.fixed,r,1),new Da(e.links,r,2),new Da(e.marks,s,9)];for(let a of this.strips)this.scene.add(a.drawn);this.colours=sb(t);let o=a=>new ad(this.material(nb,sd,{bias:1e-4,bodies:1,dashes:a,colors:this.colours},{}));this.trails={bodies:o(0),ghost:o(1)};for(let a of ld)this.scene.add(this.trails[a].drawn);for(let a of e.scene.water){let{level:l,wave:c,speed:h}=a,f={level:l,wave:c,speed:h,time:0,cells:a.mode==="step",alpha:.55};for(let d of[!1,!0]){let p=this.material(ib,rb,f,{transparent:!0,side:nr,colorWrite:d}),m=ob(a,e.bounds,p);m.renderOrder=d?8:7,this.waters.push({mesh:m,material:p}),this.scene.add(m)}}}look(e){let{right:t,up:i,back:r,eye:s,near:o,far:a,width:l,height:c,ratio:h}=e,f=this.common;f.view.value.set(t[0],t[1],t[2],-xt(t,s),i[0],i[1],i[2],-xt(i,s),r[0],r[1],r[2],-xt(r,s),0,0,0,1);let d=1/Math.tan(rl/2),p=1/(o-a);f.projection.value.set(d*c/l,0,0,0,0,d,0,0,0,0,(o+a)*p,2*o*a*p,0,0,-1,0);let[m,x]=[Math.max(1,Math.round(l*h)),Math.max(1,Math.round(c*h))];(this.canvas.width!==m||this.canvas.height!==x)&&this.renderer.setSize(m,x,!1),f.pixels.value.set(m,x),f.ratio.value=h,f.near.value=o,f.smallest.value=6/d/c,f.ink.value.set(...this.picture.theme.ink)}draw(e){let t=this.picture;if(!t||this.lost)return;this.look(e);for(let o of ld){let a=t.layers[o];if(this.placed[o]!==a.version){this.placed[o]=a.version;for(let l of this.batches[o]){for(let c of l.drawn)c.visible=a.shown;a.shown&&l.place(a.position,a.orientation,a.hidden)}}this.trails[o].sync(t.trails[o])}for(let o of this.strips)o.sync();for(let{material:o}of this.waters)o.uniforms.time.value=t.time;let[i,r,s]=t.theme.ground;this.renderer.getContext().clearColor(i,r,s,1),this.renderer.setClearColor(Math.round(i*255)<<16|Math.round(r*255)<<8|Math.round(s*255),1),this.renderer.render(this.scene,this.camera)}clear(){for(let e of ld){for(let t of this.batches[e])t.dispose();this.trails?.[e].dispose(),this.trails?.[e].material.dispose()}for(let e of this.strips)e.dispose();for(let{mesh:e,material:t}of this.waters)e.geometry.dispose(),t.dispose();this.colours?.dispose(),this.batches={bodies:[],ghost:[]},this.strips=[],this.waters=[],this.trails=null,this.scene.clear()}dispose(){this.clear();for(let e of Object.values(this.materials))e.dispose();this.canvas.removeEventListener("webglcontextlost",this.onLost),this.canvas.removeEventListener("webglcontextrestored",this.onRestored),this.renderer.dispose(),this.renderer.forceContextLoss()}};var y2=()=>/[?&#]webgl=off\b/.test(`${location.search}${location.hash}`),Bm=null;function v2(){if(Bm!==null)return Bm;let n=document.createElement("canvas").getContext("webgl2"),e=n?.getExtension("WEBGL_debug_renderer_info"),t=e?String(n.getParameter(e.UNMASKED_RENDERER_WEBGL)):"";return n?.getExtension("WEBGL_lose_context")?.loseContext(),Bm=/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)}function ab(){if(!y2()){let n=document.createElement("canvas"),e=n.getContext("webgl2",{antialias:!v2(),alpha:!1,powerPreference:"high-performance"});if(e)try{return new cd(n,e)}catch{}}return new nd(document.createElement("canvas"))}var ud=class{constructor(e,t,i){this.options=i;this.root.className="scene3d",e.append(this.root),this.stage=ab(),this.stage.onChange=()=>this.relabel(),this.webgl=this.stage.webgl,this.element=this.stage.canvas,this.element.tabIndex=0,this.element.setAttribute("role","application"),this.element.setAttribute("aria-roledescription","3D view"),this.element.setAttribute("aria-label",`${i.label}. Arrow keys turn, plus and minus zoom, Home frames all.`),this.over.className="scene3d-over",this.over.setAttribute("aria-hidden","true"),this.note.className="scene3d-note",this.note.setAttribute("role","status"),this.root.append(this.element,this.over,this.note),this.picture=new ql(t,sp(this.root),i.bounds),this.stage.show(this.picture),this.state=op(this.picture.bounds,4/3),this.controls=new $c(this.element,this),this.resized.observe(this.root),this.restyled.observe(document.documentElement,{attributes:!0,attributeFilter:["class","style","data-theme"]}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.retheme(),{signal:this.stop.signal})}options;element;webgl;onCamera=null;onFrameAll=null;onGrab=null;onPull=null;onRelease=null;root=document.createElement("div");over=document.createElement("canvas");note=document.createElement("div");stage;controls;picture;state;framed=!1;framing=null;stale=!0;overStale=!0;held=null;stop=new AbortController;resized=new ResizeObserver(()=>this.turned());restyled=new MutationObserver(()=>this.retheme());get camera(){return this.state}set camera(e){this.state=bx(e),this.framed=!0,this.turned()}moveCamera(e){this.camera=e,this.onCamera?.(this.state)}frameOn(e){this.framing=Vc(e),this.turned()}frameAll(){this.framed=!1,this.turned()}reset(){this.frameAll(),this.view(),this.onFrameAll?this.onFrameAll():this.onCamera?.(this.state)}show(e,t,i){this.picture.layers[e].set(t),Number.isFinite(i)&&(this.picture.time=i),this.stale=!0,e==="bodies"&&this.relabel()}relabel(){let e=this.picture.lost(),t=e.length>3?`${e.slice(0,3).join(", ")} and ${e.length-3} more`:e.join(", "),i=this.stage.lost?"the graphics card was lost; waiting for it":e.length>0?`not finite: ${t}`:"";this.note.textContent!==i&&(this.note.textContent=i),this.stale=!0}trails(e,t,i,r){this.picture.setTrail(e,t,i,r),this.stale=!0}arrows(e){this.picture.arrows=e,this.stale=!0}contacts(e,t){this.picture.setContacts(e,t),this.stale=!0}pulls(e){this.picture.pulls=e,this.stale=!0}links(e){this.picture.linksShown=e,this.stale=!0}replaceScene(e){let{linksShown:t}=this.picture;this.picture=new ql(e,this.picture.theme,this.options.bounds),this.picture.linksShown=t,this.stage.show(this.picture),this.relabel(),this.turned()}retheme(){this.picture.theme=sp(this.root),this.turned()}view(){let e=Math.max(this.root.clientWidth,1),t=Math.max(this.root.clientHeight,1),i=this.framing??this.picture.bounds;this.framed||(this.state=op(i,e/t));let r=Tt(mt(i.max,i.min));return Sx(this.state,{width:e,height:t,ratio:Math.min(devicePixelRatio||1,2)},r)}metresPerPixel(){return fr(this.view())}ray(e,t,i){return this.webgl?Mx(e,t,i):wx(e,t,i)}grab(e,t){let i=this.picture.layers.bodies;if(!this.onGrab||!i.shown)return!1;let r=this.view(),s=fr(r),o=h=>6*s*(this.webgl?h/r.distance:1),a=Cx(this.ray(r,e,t),this.picture.solids,i,o);if(!a||this.picture.scene.body[a.body].locked)return!1;let{body:l,point:c}=a;return this.held=c,this.onGrab({body:l,point:c,anchor:Jt(Ki(i.turn(l)),mt(c,i.at(l)))}),!0}pull(e,t){if(!this.held)return;let i=this.view(),{from:r,along:s}=this.ray(i,e,t),o=xt(mt(this.held,r),i.back)/xt(s,i.back);this.onPull?.(je(r,it(s,o)))}release(){this.held=null,this.onRelease?.()}render(){if(!this.stale)return;this.stale=!1,this.picture.relink();let e=this.view(),{grid:t}=this.picture;this.picture.setEye(e.eye,this.framing??this.picture.bounds),this.picture.grid!==t&&(this.overStale=!0),this.stage.draw(e),this.overStale&&this.drawOver(e)}drawOver(e){this.overStale=!1,[this.over.width,this.over.height]=[this.element.width,Math.round(cp*e.ratio)];let t=this.picture.scene.plane.length>0?this.picture.grid:null,i=this.over.getContext("2d");i&&Ax(i,e,this.picture.theme,t)}turned(){this.stale=this.overStale=!0}get size(){return{width:this.element.width,height:this.element.height}}paint(e,t,i){this.stale=!0,this.render(),e.drawImage(this.element,t,i),e.drawImage(this.over,t,i+this.element.height-this.over.height)}png(){let e=document.createElement("canvas");this.stale=!0,this.render(),[e.width,e.height]=[this.element.width,this.element.height];let t=e.getContext("2d");return t&&this.paint(t,0,0),new Promise((i,r)=>e.toBlob(s=>s?i(s):r(new Error("the picture could not be kept")),"image/png"))}dispose(){this.stop.abort(),this.resized.disconnect(),this.restyled.disconnect(),this.controls.dispose(),this.stage.dispose(),this.root.remove(),this.onCamera=this.onFrameAll=this.onGrab=this.onPull=this.onRelease=null}};function hd(n,e,t){return new ud(n,e,t)}function b2(n,e){let t=n.getContext("2d");[...e].forEach((i,r)=>{r===0&&([n.width,n.height]=[i.width,i.height]),i.width>0&&i.height>0&&t?.drawImage(i,0,0)})}function lb(n,e,t){let i=document.createElement("canvas");i.className="pane-paper";let r=()=>{e(),queueMicrotask(()=>{t(),b2(i,n.querySelectorAll("canvas")),n.after(i)})},s=()=>i.remove();return addEventListener("beforeprint",r),addEventListener("afterprint",s),()=>{removeEventListener("beforeprint",r),removeEventListener("afterprint",s),s()}}var Na=class{linked=!0;moved=null;scenes=new Set;join(e){return this.moved&&this.linked&&(e.camera=this.moved),this.scenes.add(e),e.onCamera=t=>{if(this.moved=t,this.linked)for(let i of this.scenes)i!==e&&(i.camera=t)},()=>{this.scenes.delete(e)}}};function cb(n,e){let t=n.position.length/n.time.length/3;return{position:n.position.subarray(3*t*e,3*t*(e+1)),orientation:n.orientation.subarray(4*t*e,4*t*(e+1))}}function S2(n,{bodies:e,ghost:t},i,r,s){if(e.time.length===0){n.show("bodies",null,i),n.trails("bodies",null,0,0),n.show("ghost",null,i);return}let o=Pr(e.time,i),a=e.time[o];n.show("bodies",cb(e,o),i);let l=e.position.length/e.time.length/3;n.trails("bodies",s?e.position:null,l,o);let c=t&&t.time.length>0?Pr(t.time,a):-1,h=r&&t&&c>=0&&Math.abs(t.time[c]-a)<=1e-6*Math.abs(a);n.show("ghost",h?cb(t,c):null,i)}async function M2(n,e){if(!n)return;let t=document.createElement("a");t.href=URL.createObjectURL(await n.png()),t.download=`${e.replace(/[^\w.-]+/g,"_")}.png`,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e3)}function Jl({title:n,scene:e,motions:t,bounds:i,cursor:r,cameras:s,ghost:o,trails:a}){let l=Ht(null),c=Ht(null),h=Ht(null),f=Ht(()=>{});return f.current=()=>{c.current&&S2(c.current,t,r.time,o,a)},Rt(()=>{let d=hd(l.current,e,{label:`3D picture of ${J(n)}`,...i?{bounds:i}:{}});c.current=d,!d.webgl&&h.current&&(h.current.textContent="No WebGL here: drawn flat, without perspective.");let p=[s.join(d),r.listen(()=>f.current()),Fo(()=>f.current()),lb(l.current,()=>f.current(),()=>d.render())],m=requestAnimationFrame(function x(){d.render(),m=requestAnimationFrame(x)});return()=>{cancelAnimationFrame(m);for(let x of p)x();d.dispose(),c.current=null}},[e,i,r,s]),Rt(()=>f.current()),u("figure",{class:"pane",children:[u("figcaption",{children:[u("strong",{children:J(n)})," ",u("span",{class:"note",ref:h})," ",u("button",{type:"button",class:"on-screen",onClick:()=>{M2(c.current,n)},children:"save as PNG"})]}),u("div",{class:"pane-picture",ref:l})]})}function Vm(n,e){let{motion:t,ghost:i}=e.trace;return{title:n,block:e,frames:e.frames(t),ghost:i?e.frames(i):null}}function w2({ghost:n,frames:e}){return!n||n.time.length>=e.time.length?"":`It is known at ${Pt(n.time.length,"time")} and shown at no other. `}function us(n){return[n.engine,n.integrator,n.dt_text].join(" ")}function ub({scene:n,own:e,other:t,choices:i,chosen:r,bounds:s,cursor:o,trouble:a}){let[l,c]=et(!0),[h,f]=et(!0),[d,p]=et(!0),m=Ue(()=>new Na,[]);m.linked=d;let x=e.block.trace.ghost,_=[["ghost of the truth",l,c,e.ghost===null],["trails",h,f,!1],["cameras linked",d,p,t===null]],g={scene:n,bounds:s,cursor:o,cameras:m,ghost:l,trails:h};return u("section",{"aria-labelledby":"side-heading",children:[u("h3",{id:"side-heading",children:"Side by side"}),u("div",{class:"side-tools on-screen",children:[u("label",{children:["beside it"," ",u("select",{value:r,onChange:v=>an({other:v.currentTarget.value||"-"}),children:[u("option",{value:"",children:"nothing"}),i.map(v=>u("option",{value:us(v),children:J(us(v))},us(v)))]})]}),_.map(([v,E,M,I])=>u("label",{children:[u("input",{type:"checkbox",checked:E,disabled:I,onChange:()=>M(!E)})," ",v]},v))]}),a?u("p",{class:"note",children:J(a)}):null,u("div",{class:"panes",children:[u(Jl,{title:e.title,motions:{bodies:e.frames,ghost:e.ghost},...g},e.title),t?u(Jl,{title:t.title,motions:{bodies:t.frames,ghost:t.ghost},...g},t.title):null]}),u("p",{class:"note",children:[x?`The ghost follows ${J([x.follows,x.source].filter(Boolean).join(": "))}. ${w2(e)}`:"This scene has no truth that tells where its bodies are: there is no ghost. ","Shown is the stored frame nearest to the cursor; nothing is drawn between frames."]})]})}var zm=[.001,.01,.1,.25,.5,1,2,5,10,100];function hb(n){return n>=2&&n<=60?1:zm.reduce((e,t)=>Math.abs(Math.log(t*10/n))<Math.abs(Math.log(e*10/n))?t:e)}function db(n,e){let[t,i]=et(!1);return Rt(()=>{if(!t)return;n.running=!0;let s=matchMedia("(prefers-reduced-motion: reduce)").matches?500:0,o=performance.now(),a=requestAnimationFrame(function l(c){c-o>=s&&(n.pin+=(c-o)/1e3*e,o=c),n.pin>=n.whole[1]?i(!1):a=requestAnimationFrame(l)});return()=>{n.running=!1,cancelAnimationFrame(a)}},[t,n,e]),{playing:t,toggle:()=>{!t&&n.pin>=n.whole[1]&&(n.pin=n.whole[0]),i(!t)}}}function Hm(n,e,t){let i=Pr(e,n.pin),r=Math.min(e.length-1,Math.max(0,i+t));n.pin=e[r]??n.pin}var T2='input, select, textarea, button, a, summary, canvas, [role="region"], [role="grid"]';function A2(n,e){wi(()=>{let t=i=>{let r=i.key==="ArrowLeft"?-1:i.key==="ArrowRight"?1:0;r===0||i.altKey||i.ctrlKey||i.metaKey||i.target instanceof Element&&i.target.closest(T2)||(i.preventDefault(),Hm(n,e,i.shiftKey?10*r:r))};return addEventListener("keydown",t),()=>removeEventListener("keydown",t)},[n,e])}function E2({cursor:n,divergence:e}){return u("p",{class:"jump",children:[u("button",{type:"button",disabled:!e,onClick:()=>e&&(n.pin=e.time),children:"jump to the first divergence"})," ",e?`${e.what}, at ${ge(e.time,6)} s`:"no first violation is recorded, and the engines shown do not part by 1 % of the extent"]})}function dd({cursor:n,frames:e,divergence:t}){let i=bc(n),[r,s]=et(()=>hb(n.whole[1]-n.whole[0])),{playing:o,toggle:a}=db(n,r);A2(n,e);let l=Pr(e,i);return u("div",{class:"timeline on-screen",role:"group","aria-label":"Time cursor of all plots and pictures",children:[u("div",{class:"timeline-row",children:[u("button",{type:"button",onClick:a,children:o?"pause":"play"}),u("button",{type:"button",onClick:()=>Hm(n,e,-1),children:"\u22121 frame"}),u("button",{type:"button",onClick:()=>Hm(n,e,1),children:"+1 frame"}),u("input",{type:"range","aria-label":"time",min:n.whole[0],max:n.whole[1],step:(n.whole[1]-n.whole[0])/1e3,value:i,"aria-valuetext":`${ge(i)} s`,onInput:c=>n.pin=Number(c.currentTarget.value)}),u("output",{class:"number",children:[ge(i,5)," s of ",ge(n.whole[1],5)," s, frame ",l+1," of ",e.length]}),u("label",{children:["speed"," ",u("select",{value:r,onChange:c=>s(Number(c.currentTarget.value)),children:zm.map(c=>u("option",{value:c,children:[c," \xD7"]},c))})]}),u("button",{type:"button",onClick:()=>n.lookCloser(),children:"plots: closer"}),n.window?u("button",{type:"button",onClick:()=>n.window=null,children:"plots: whole time"}):null]}),t===void 0?null:u(E2,{cursor:n,divergence:t})]})}var C2=[{title:"Energy",names:["energy","kinetic energy"]},{title:"Momentum",names:["momentum"]},{title:"Angular momentum",names:["angular momentum"]}];function fb(n,e,t,i,r){let s=Float64Array.from(n.floats(e.value)),o=s[0]??0;return{label:i,style:r,time:n.floats(e.time),value:t?s.map(a=>a-o):s}}function R2(n,e,t,i){return e.trace.totals.filter(s=>n.includes(s.name)).flatMap((s,o)=>{let a=`${s.name}${s.component?`, ${s.component}`:""}`,l=f=>f.name===s.name&&f.component===s.component,c=t?.block.trace.totals.find(l),h=[fb(e,s,i,a,o)];return t&&c&&h.push({...fb(t.block,c,i,`${t.engine}: ${a}`,o),faint:!0}),h})}function pb({block:n,other:e,cursor:t}){let[i,r]=et(!0),s=Ue(()=>C2.map(({title:o,names:a})=>({title:o,unit:n.trace.totals.find(l=>a.includes(l.name))?.unit??"",curves:R2(a,n,e,i)})),[n,e,i]);return u("section",{"aria-labelledby":"totals-heading",children:[u("h3",{id:"totals-heading",children:"Energy and momenta against time"}),u("label",{class:"on-screen",children:[u("input",{type:"checkbox",checked:i,onChange:()=>r(!i)})," change since the start"]}),n.trace.totals.length===0?u("p",{class:"empty",children:"The trace holds none."}):null,u("div",{class:"total-plots",children:s.filter(({curves:o})=>o.length>0).map(({title:o,unit:a,curves:l})=>{let c=`${i?"\u0394 ":""}${o.toLowerCase()} [${a}]`;return u("figure",{children:[u(As,{curves:l,label:Cs(o,l,a),axis:c,log:!1,cursor:t,number:ge,height:250}),u("figcaption",{children:u(Es,{curves:l,cursor:t,log:!1,unit:a,caption:c})})]},o)})}),u("p",{class:"note",children:"Curves are stored in single precision: a change below 6e-8 of the value itself does not show. The verdicts above come from the whole states."})]})}var Zl=new Map,P2=4;function I2(n){let e=Zl.get(n);if(e)return e;let t=dc.of(n);Zl.set(n,t);let[i]=Zl.keys();return Zl.size>P2&&i!==void 0&&Zl.delete(i),t}function fd(n){let[e,t]=et({of:null,value:{state:"absent"}});return Rt(()=>{if(n===null)return;let i=!0,r=s=>i&&t({of:n,value:s});return I2(n).then(s=>r({state:"ready",block:s}),s=>r({state:"broken",why:String(s)})),()=>{i=!1}},[n]),n===null?{state:"absent"}:e.of===n?e.value:{state:"loading"}}function mb(n,e){let t=i=>i.scenario===e.scenario&&i.engine===e.engine&&i.integrator===e.integrator&&i.dt_text===e.dt;return n.find(t)??null}function L2(n,e){let t=s=>s.startsWith("in-house"),i=s=>t(e.engine)?!t(s.engine):s.engine==="in-house",r=n.filter(s=>s.dt_text===e.dt);return r.find(i)??n.find(i)??r[0]??n[0]??null}function D2(n,e,t,i,r,s){for(let d of[...n.verdicts].sort((p,m)=>Za(m,p))){let p=e.trace.errors.find(m=>m.claim===d.claim)?.first_violation;if(p)return{time:p.time,what:`first violation of '${J(d.claim)}' (${d.status}), step ${p.step}`}}if(!i||!(s>0))return null;let o=D0(t.frames,i.frames,.01*s);if(!o)return null;let a=r?.scene.body[o.body]?.name??`body ${o.body+1}`,l=Number.isFinite(o.distance)?Gn(o.distance,"m"):"a distance that is not finite",c=`${J(a)} of ${J(t.title)} and of ${J(i.title)}`,h=`over 1 % of the scene's extent of ${ge(s)} m`,f=`no first violation is recorded; ${c} part by ${l}, ${h}`;return{time:o.time,what:f}}function N2(n,e,t){let i=[t,n.time[n.time.length-1]??0];for(let s of e.trace.errors)i.push(s.first_violation?.time??0);let r=Math.max(...i.filter(Number.isFinite));return[0,r>0?r:1]}function F2(n){let{t:e="0"}=An(),t=Ht(e);Rt(()=>{e!==t.current&&(t.current=e,n.pin=Number(e)||0)},[e,n]),Rt(()=>{let i=0,r=n.listen(()=>{clearTimeout(i),i=window.setTimeout(()=>{let s=String(Number(n.pin.toPrecision(6)));s!==t.current&&(t.current=s,an({t:s==="0"?"":s}))},300)});return()=>{r(),clearTimeout(i)}},[n])}function gb({index:n,cell:e,view:t,block:i,rows:r}){let{other:s}=An(),o=us({scenario:e.scenario,engine:e.engine,integrator:e.integrator,dt_text:e.dt,block:0}),a=Ue(()=>n.traces.filter(v=>v.scenario===e.scenario&&us(v)!==o),[n,e,o]),l=s==="-"?null:a.find(v=>us(v)===s)??L2(a,e),c=fd(l?.block??null),h=Ue(()=>Vm(o,i),[o,i]),f=c.state==="ready"?c.block:null,d=Ue(()=>f&&l?Vm(us(l),f):null,[f,l]),p=Ue(()=>wc(h.ghost,[h.frames,d?.frames??null]),[h,d]),m=Ue(()=>new Ms(N2(h.frames,i,t?.duration??0),Number(Js().t??0)||0),[h,i,t]);F2(m);let x=Ue(()=>D2(e,i,h,d,t,p?Mc(p):0),[e,i,h,d,t,p]),_=Ue(()=>d&&l?{engine:l.engine,block:d.block}:null,[d,l]),{remarks:g}=i.trace;return u(Oe,{children:[u(dd,{cursor:m,frames:h.frames.time,divergence:x}),t?u(ub,{scene:t.scene,own:h,other:d,choices:a,chosen:l?us(l):"",bounds:p,cursor:m,trouble:c.state==="broken"?`The other trace cannot be read: ${c.why}`:""}):null,u(dx,{rows:r,block:i,other:_,cursor:m}),u(pb,{block:i,other:_,cursor:m}),u(px,{events:i.trace.events,cursor:m}),g.length>0?u("section",{"aria-labelledby":"remarks-heading",children:[u("h3",{id:"remarks-heading",children:"Remarks of the harness"}),u("ul",{children:g.map((v,E)=>u("li",{children:u(Nt,{text:v})},E))})]}):null]})}function hs(n,e){return(e??1)===1?n:n?`${n} (${e} substeps)`:`${e} substeps`}function U2(n,e){return[...new Set(n.map(e))].join(" | ")}function k2({dt:n,dt_text:e}){let t=li(e);return t.includes("/")?`${t} (${Ln(n)})`:t}var O2=[["engine",n=>`${n.engine} ${n.version}${n.version_listed?"":" (a version that expected.toml does not list)"}`],["precision",n=>n.precision],["path",n=>n.path],["gyroscopic term",n=>n.gyroscopic],["integrator",n=>n.integrator],["step",n=>hs(k2(n),n.substeps)],["sampling",n=>n.sampling],["CPU time",n=>`${Ln(n.cpu_seconds)} for ${n.body_steps} body-steps${n.cpu_verified?"":" (not verified)"}`],["scenario hash",n=>n.scenario_hash]];function xb({verdicts:n,view:e}){return u("section",{"aria-labelledby":"run-heading",children:[u("h3",{id:"run-heading",children:"Run"}),u("dl",{class:"facts",children:[O2.map(([t,i])=>u("div",{children:[u("dt",{children:t}),u("dd",{children:u(Nt,{text:U2(n,i)})})]},t)),e?u("div",{children:[u("dt",{children:"scenario"}),u("dd",{children:[ge(e.duration)," s, nominal step ",Ln(e.step),", "," ",Pt(e.scene.body.length,"body","bodies"),", tags: ",J(e.tags.join(", ")||"none")]})]}):null]})]})}function yb({verdicts:n}){let e=Object.entries(Object.assign({},...n.map(i=>i.settings))),t=[...new Set(n.flatMap(i=>i.unforceable))];return u("section",{"aria-labelledby":"settings-heading",children:[u("h3",{id:"settings-heading",children:"Settings forced on the engine"}),e.length===0?u("p",{children:"None: it ran as it is."}):null,u("dl",{class:"facts",children:e.map(([i,r])=>u("div",{children:[u("dt",{children:J(i)}),u("dd",{children:J(r)})]},i))}),u("h3",{children:"Known limits of the engine"}),t.length===0?u("p",{children:"Nothing is known."}):null,u("ul",{children:t.map(i=>u("li",{children:J(i)},i))})]})}var vb="\u2013";function pd(n,e){return n===null?vb:Gn(n,e==="1"?"":e)}function B2(n){let e=n.body_count-n.bodies.length,t=n.bodies.join(", ")+(e>0?` and ${e} more`:"");return n.body_count===0?"the scene":t}var _b=[["part",B2],["method",n=>n.method+(n.order>0?`, order ${n.order}`:"")||vb],["since",n=>pd(n.since,"s")],["until",n=>n.until===null?"the end":pd(n.until,"s")],["times",n=>`${n.count}`],["asked, or cap",n=>pd(n.limit,n.limit_unit)],["reached",n=>pd(n.reached,n.unit)],["in words",n=>n.text]];function bb({verdicts:n}){let e=n.find(t=>t.diagnostics.length>0)?.diagnostics??[];return e.length===0?null:u("section",{"aria-labelledby":"diagnostics-heading",children:[u("h3",{id:"diagnostics-heading",children:"What the engine says of this run"}),u("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Diagnostics of this run",children:u("table",{children:[u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"kind"}),_b.map(([t])=>u("th",{scope:"col",children:t},t))]})}),u("tbody",{children:e.map((t,i)=>u("tr",{children:[u("th",{scope:"row",children:J(t.kind)}),_b.map(([r,s])=>u("td",{children:u(Nt,{text:s(t)})},r))]},i))})]})})]})}function Sb({verdicts:n}){let e=[...new Set(n.map(t=>t.stderr))].filter(t=>t!=="");return u("section",{"aria-labelledby":"output-heading",children:[u("h3",{id:"output-heading",children:"What the engine wrote to stderr"}),e.length===0?u("p",{children:"Nothing."}):null,e.map((t,i)=>u(Oo,{text:t,label:"stderr of the engine"},i))]})}var V2=[];function z2({matrix:n,cell:e}){let t=n.rows.find(i=>i.scenario===e.scenario&&i.dt===e.dt);return u("ul",{class:"neighbours on-screen","aria-label":"Engines of this scenario",children:(t?.cells??[]).flatMap((i,r)=>i?u("li",{children:u("a",{href:Qn(Cr(i)),"aria-current":i===e?"page":void 0,children:[J(n.columns[r].label)," ",u("span",{class:`status ${Yn[i.worst].tone}`,children:Yn[i.worst].glyph}),i.differs?u(Yr,{}):null]})},r):[])})}function H2({cell:n,view:e}){let t=xn(n.worst)&&n.digits!==null?`, ${_c(n.digits)}`:"";return u(Oe,{children:[u("h2",{id:"cell-heading",tabIndex:-1,children:[J(n.scenario)," / ",J(n.engine)," ",u("span",{class:"note",children:J([n.integrator,`step ${li(n.dt)}`].filter(Boolean).join(", "))})]}),u("p",{class:"cell-verdict",children:[u(cr,{status:n.worst}),t," by the worst of ",Pt(n.verdicts.length,"claim"),n.differs?" ":"; as expected.toml says",n.differs?u(Yr,{text:"differs from expected.toml"}):null]}),e?u(Oe,{children:[u("p",{children:u("strong",{children:u(Nt,{text:e.title})})}),u("p",{children:u(Nt,{text:e.story})})]}):u("p",{class:"note",children:"The report does not describe this scenario."})]})}function G2({cell:n}){let e=[...new Set(n.verdicts.map(t=>t.reproduce))];return u("section",{"aria-labelledby":"reproduce-heading",children:[u("h3",{id:"reproduce-heading",children:"To reproduce it"}),e.map(t=>u(vc,{text:t},t))]})}function W2(){an(Ss(Js().section??"matrix"),!0)}function $2(){wi(()=>{let n=e=>{e.key==="Escape"&&!e.defaultPrevented&&W2()};return addEventListener("keydown",n),()=>removeEventListener("keydown",n)},[])}function X2(n,e){let{claims:t}=An(),i=Ue(()=>{if(t!==void 0)return new Set(t.split(",").filter(o=>o!=="-").map(Number));let[s]=yc(n.verdicts.filter(o=>e.has(o.claim)));return new Set(s?[n.verdicts.indexOf(s)]:[])},[t,n,e]);return[i,s=>{let o=new Set(i);o.delete(s)||o.add(s),an({claims:o.size===0?"-":[...o].sort((a,l)=>a-l).join(",")})}]}function Mb({index:n,matrix:e,cell:t,view:i}){let r=Ue(()=>mb(n.traces,t),[n,t]),s=fd(r?.block??null),o=s.state==="ready"?s.block.trace.errors:V2,a=Ue(()=>new Set(o.map(d=>d.claim)),[o]),l=Ue(()=>E0(t.verdicts,i,o),[t,i,o]),[c,h]=X2(t,a),f=Ue(()=>l.filter(d=>c.has(d.index)),[l,c]);return $2(),Rt(()=>{scrollTo(0,0),document.getElementById("cell-heading")?.focus()},[t]),u("article",{class:"cell-page","aria-labelledby":"cell-heading",children:[u("p",{class:"on-screen",children:[u("a",{href:Qn(Ss(Js().section??"matrix")),children:"back to the matrix"})," ",u("kbd",{children:"Escape"})]}),u(z2,{matrix:e,cell:t}),u(H2,{cell:t,view:i}),u(G2,{cell:t}),u(R0,{rows:l,shown:c,toggle:h}),s.state==="ready"?u(gb,{index:n,cell:t,view:i,block:s.block,rows:f},r.block):u(q2,{state:s.state,why:s.state==="broken"?s.why:n.omitted_traces,cell:t}),u("div",{class:"columns",children:[u(xb,{verdicts:t.verdicts,view:i}),u(yb,{verdicts:t.verdicts})]}),u(bb,{verdicts:t.verdicts}),u(Sb,{verdicts:t.verdicts})]})}function q2({state:n,why:e,cell:t}){if(n==="loading")return u("p",{role:"status",children:"Unpacking the trace\u2026"});let i=n==="broken"?"The trace cannot be read.":"No trace of this run is stored: there are no curves and no pictures.";return u("section",{"aria-label":`Trace of ${J(t.engine)}`,children:u("p",{class:"empty",children:[i," ",J(e)]})})}function Gm(n){return n.split("/")[0].replace(/(?<=.)-float$/,"")}function wb(n){let e=new Map;for(let[r,s]of n)e.set(Gm(r),e.get(Gm(r))||s);let t=[...e.keys()].sort((r,s)=>r.length-s.length),i=r=>t.find(s=>r.startsWith(`${s}-`)&&e.get(s)===e.get(r))??r;return new Map([...n.keys()].map(r=>[r,i(Gm(r))]))}function md(n,e){let t=new Map;return n.forEach(({family:i},r)=>{let s=t.get(i)??[];t.set(i,s),e[r]&&s.push(r)}),[...t].flatMap(([i,r])=>r.length>0?[{name:i,columns:r}]:[])}function Tb(n){let e=n.filter(({columns:i})=>i.length>1).length,t=n.reduce((i,{columns:r})=>i+r.length,0);return e>1||t>6}var Ab="\0",gd=class{order=new Map;several=new Map;index(e,t){let i=e+Ab+t,r=this.order.get(i);return r?r.index:(this.order.set(i,{index:this.order.size,first:e,second:t}),this.several.set(e,(this.several.get(e)??0)+1),this.order.size-1)}all(){return[...this.order.values()].map(({first:e,second:t})=>({first:e,second:t,label:this.several.get(e)>1?`${e} ${li(t)}`:e}))}};function Y2(n,e){let t=e.status!=="unsupported"&&Xi(e.status)>Xi(n.worst);if((n.worst==="unsupported"||t)&&(n.worst=e.status),xn(e.status)){let i=ar(e.measured,e.allowed);n.digits=n.digits===null?i:Math.min(n.digits,i)}n.differs||=lr(e),n.closedForm||=e.closed_form,n.verdicts.push(e)}function J2(n,e){let t=e.filter((i,r)=>n.cells[r]?.worst==="pass").map(({label:i})=>i);for(let i of n.cells)i?.worst==="unsupported"&&(i.passedBy=t)}function Z2(n){let e=new Map,t=new Map,i=new Set;for(let r of n){if(r.integrator==="")continue;e.has(r.engine)||e.set(r.engine,r.integrator);let s=[r.engine,r.scenario,r.dt_text].join(Ab);t.has(s)||t.set(s,r.integrator),t.get(s)!==r.integrator&&i.add(r.engine)}return r=>i.has(r.engine)?r.integrator||(e.get(r.engine)??""):""}function K2(n){let e=new Map;for(let t of n)e.set(t.engine,e.get(t.engine)||t.version);return e}function _d(n){let e=new gd,t=new gd,i=Z2(n),r=[],s=[];for(let c of n){let h=r[e.index(c.scenario,c.dt_text)]??=[],f=t.index(c.engine,i(c)),{scenario:d,engine:p,integrator:m,dt_text:x,status:_}=c;h[f]??={scenario:d,engine:p,integrator:m,dt:x,verdicts:[],worst:_,digits:null,differs:!1,closedForm:!1,passedBy:[]},Y2(h[f],c),s[f]=Math.max(s[f]??1,c.substeps??1)}let o=wb(K2(n)),a=t.all().map(({first:c,second:h,label:f},d)=>({engine:c,integrator:h,label:f,family:o.get(c),substeps:s[d]})),l=e.all().map(({first:c,second:h,label:f},d)=>({scenario:c,dt:h,label:f,cells:a.map((p,m)=>r[d]?.[m]??null)}));for(let c of l)J2(c,a);return{columns:a,rows:l}}function Eb(n){let e=new Map,t=new Set;for(let i of n){let r=i.dt??i.dt_text;(e.get(i.scenario)??r)!==r&&t.add(i.scenario),e.set(i.scenario,r)}return t}function Cb(n,e){let t=new Map;for(let{scenario:i,cells:r}of n.rows){let s=r[e];s&&t.set(i,(t.get(i)??!0)&&s.worst!=="unsupported")}return{run:[...t.values()].filter(Boolean).length,asked:t.size}}function Rb(n,e){let t=n.rows.find(r=>r.scenario===e.scenario&&r.dt===e.dt),i=r=>r.engine===e.engine&&r.integrator===e.integrator;return t?.cells.find(r=>r?.verdicts.some(i))??null}function Wm(n){let e=0,t=-1,i=100;for(let r of n.cells)r&&(r.differs&&(e=1),t=Math.max(t,Xi(r.passedBy.length>0?"fail":r.worst)),i=Math.min(i,r.digits??100));return[e,t,-i]}var Zn=class extends Error{constructor(t,i,r){super(t);this.at=i;this.length=r}at;length},$m=["pass","low-quality","fail","undecided","unsupported","crash","timeout","non-finite","protocol","differs","expected","none"],j2=["scenario","tag","claim"];function Q2(n){let e=[],t=0;for(;t<n.length;){let i=n[t];if(/\s/.test(i))++t;else if(i==="("||i===")")e.push({text:i,at:t++,quoted:!1});else{let r=e3(n,t);e.push(r),t+=r.length}}return e}function e3(n,e){let t=e,i="",r=-1;for(;t<n.length;++t){let s=n[t];if(s==='"')r=r<0?t:-1;else{if(r<0&&/[\s()]/.test(s))break;i+=s}}if(r>=0)throw new Zn("this quote is never closed",r,n.length-r);return{text:i,at:e,quoted:n[e]==='"',length:t-e}}function qm(n,e){let t=Array.from({length:e.length+1},(i,r)=>r);for(let i=1;i<=n.length;++i){let r=[i];for(let s=1;s<=e.length;++s)r.push(Math.min(r[s-1]+1,t[s]+1,t[s-1]+ +(n[i-1]!==e[s-1])));t=r}return t[e.length]}var Pb=100,Xm=class{constructor(e,t){this.list=e;this.end=t}list;end;next=0;depth=0;columns=[];engines=[];whole(){if(this.list.length===0)return{kind:"all"};let e=this.either(),t=this.list[this.next];if(t)throw new Zn("this closes nothing",t.at,1);return e}is(e){let t=this.list[this.next];return t!==void 0&&!t.quoted&&t.text.toLowerCase()===e}take(e){return this.is(e)?(++this.next,!0):!1}either(){let e=this.list[this.next],t=this.columns.length,i=[this.both()];for(;this.is("or");){if(this.columns.length>t)throw Ib(e);this.nested(()=>(++this.next,i.push(this.both())))}return i.length===1?i[0]:{kind:"or",parts:i}}both(){let e=[this.single()];for(;this.next<this.list.length&&!this.is("or")&&!this.is(")");)this.take("and"),e.push(this.single());let t=e.filter(({kind:i})=>i!=="all");return t.length>1?{kind:"and",parts:t}:t[0]??{kind:"all"}}single(){let e=this.list[this.next];if(!e)throw new Zn("a term is missing here",this.end,1);if(this.take("not"))return{kind:"not",part:this.nested(()=>this.single())};if(this.take("(")){let t=this.nested(()=>this.either());if(!this.take(")"))throw new Zn("this parenthesis is never closed",e.at,1);return t}if(this.is(")")||this.is("and")||this.is("or"))throw new Zn(`a term is missing before '${e.text}'`,e.at,e.text.length);return++this.next,this.term(e)}nested(e){if(++this.depth>Pb)throw new Zn(`nested deeper than ${Pb}`,this.list[this.next-1].at,1);let t=e();return--this.depth,t}term(e){let t=e.text.toLowerCase();if(e.quoted)return{kind:"word",text:t};let i=/^(?:(.*):)?digits(<=|>=|<|>|=)(.*)$/.exec(t);if(i)return this.digits(e,i[1]??"*",i[2],i[3]);if(t.endsWith(":"))throw new Zn(`nothing stands after '${t}'`,e.at,t.length);if(t.startsWith("columns:"))return this.show(e,t.slice(8));let r=j2.find(l=>t.startsWith(`${l}:`));if(r)return{kind:"field",field:r,glob:t.slice(r.length+1)};let s=t.lastIndexOf(":");if(s<0)return{kind:"word",text:t};let o=t.slice(0,s),a=t.slice(s+1);if(o==="")throw new Zn("an engine is missing before the colon",e.at,t.length);if(!$m.includes(a))throw new Zn(t3(a),e.at+s+1,a.length);return{kind:"status",engine:this.engine(o,e.at),status:a}}digits(e,t,i,r){let s=Number(r);if(r===""||!Number.isFinite(s)){let o=e.at+e.text.length-r.length;throw new Zn(`a number must follow, not '${r}'`,o,Math.max(1,r.length))}return{kind:"digits",engine:this.engine(t,e.at),relation:i,value:s}}engine(e,t){return e==="any"||e==="*"?"*":(this.engines.push({name:e,at:t}),e)}show(e,t){if(this.depth>0)throw Ib(e);return this.columns.push(...t.split(",").filter(i=>i!=="")),{kind:"all"}}};function Ib(n){let e="columns: says what is shown; it cannot stand within 'or', 'not' or parentheses";return new Zn(e,n.at,n.text.length)}function t3(n){let e=$m.filter(i=>qm(i,n)<=2)[0],t=e?`did you mean '${e}'?`:`there are ${$m.join(", ")}`;return`no status is called '${n}': ${t}`}function Lb(n){let e=new Xm(Q2(n),n.length);return{query:e.whole(),columns:e.columns,engines:e.engines}}function So(n){let e=n.toLowerCase();return t=>n3(e,t.toLowerCase())}function n3(n,e){let[t,i]=[0,0],[r,s]=[-1,0];for(;i<e.length;)if(n[t]==="*")r=t++,s=i;else if(t<n.length&&(n[t]==="?"||n[t]===e[i]))++t,++i;else if(r>=0)t=r+1,i=++s;else return!1;for(;n[t]==="*";)++t;return t===n.length}var i3={"<":(n,e)=>n<e,"<=":(n,e)=>n<=e,">":(n,e)=>n>e,">=":(n,e)=>n>=e,"=":(n,e)=>n===e};function r3(n){switch(n){case"none":return e=>e===null;case"pass":return e=>e?.worst==="pass";case"differs":return e=>e?.differs===!0;case"expected":return e=>e?.differs===!1;default:return e=>e!==null&&e.verdicts.some(t=>t.status===n)}}var s3=64;function Nb(n,e){for(let{name:t,at:i}of n){let r=So(t);if(e.some(a=>r(a.engine)||r(a.label)))continue;let s=t.length>s3?void 0:e.map(a=>a.engine).find(a=>qm(a.toLowerCase(),t)<=2),o=s?`, did you mean '${s}'?`:"";throw new Zn(`no engine of this report is called '${t}'${o}`,i,t.length)}}function Db(n,e,t){let i=So(n),r=e.flatMap((s,o)=>i(s.engine)||i(s.label)?[o]:[]);return s=>r.some(o=>t(s.cells[o]??null))}function o3(n,e,t){let i=So(e);switch(n){case"scenario":return r=>i(r.scenario);case"tag":return r=>t.get(r.scenario)?.tags.some(i)??!1;case"claim":return r=>r.cells.some(s=>s?.verdicts.some(o=>i(o.claim)||i(o.observable)))}}function a3(n,e){let t=/[*?]/.test(n)?So(`*${n}*`):i=>i.toLowerCase().includes(n);return i=>t(i.scenario)||t(e.get(i.scenario)?.title??"")}function Ym(n,e,t){let i=r=>Ym(r,e,t);switch(n.kind){case"all":return()=>!0;case"and":{let r=n.parts.map(i);return s=>r.every(o=>o(s))}case"or":{let r=n.parts.map(i);return s=>r.some(o=>o(s))}case"not":{let r=i(n.part);return s=>!r(s)}case"word":return a3(n.text,t);case"field":return o3(n.field,n.glob,t);case"status":return Db(n.engine,e,r3(n.status));case"digits":{let r=i3[n.relation];return Db(n.engine,e,s=>s?.digits!=null&&r(s.digits,n.value))}}}function Jm(n,e){let t=e.map(()=>n.length===0||n[0].startsWith("-"));for(let i of n){let r=i.startsWith("-"),s=So(r?i.slice(1):i);e.forEach((o,a)=>{(s(o.engine)||s(o.label))&&(t[a]=!r)})}return t}function l3(n){let e=/"[^"]*"|(^|\s)columns:("[^"]*"|[^\s()"])*/gi;return n.replace(e,t=>t.startsWith('"')?t:"").trim()}function Fb(n,e){return(e.filter(i=>i.engine===n.engine).length>1?n.label:n.engine).replace(/[\s()",]/g,"?")}function xd(n,e,t){let i=l3(n);if(t.every(Boolean))return i;let r=e.filter((a,l)=>!t[l]),s=e.filter((a,l)=>t[l]),o=r.length<s.length||s.length===0?r.map(a=>`-${Fb(a,e)}`):s.map(a=>Fb(a,e));return`${i} columns:${o.join(",")}`.trim()}function c3({family:n,columns:e,shown:t,onShow:i}){let r=n.columns.filter(a=>t[a]).length,s=r===n.columns.length,o=n.columns.length===1&&e[n.columns[0]].label===n.name;return u("fieldset",{class:"family",children:[u("legend",{children:u("label",{children:[u("input",{type:"checkbox",checked:s,indeterminate:r>0&&!s,onChange:()=>i(n.columns,!s)}),u("span",{children:[J(n.name),o?null:u("span",{class:"of",children:[", ",r," of ",n.columns.length]})]})]})}),o?null:n.columns.map(a=>u("label",{children:[u("input",{type:"checkbox",checked:t[a],onChange:()=>i([a],!t[a])}),u("span",{children:J(e[a].label)})]},a))]})}function Ub({columns:n,shown:e,onChange:t}){let i=(s,o)=>t(e.map((a,l)=>s.includes(l)?o:a)),r=n.map(()=>!0);return u("details",{class:"column-choice",children:[u("summary",{children:["Columns: ",e.filter(Boolean).length," of ",n.length]}),u("fieldset",{class:"families",children:[u("legend",{class:"unseen",children:"Columns to show"}),md(n,r).map(s=>u(c3,{family:s,columns:n,shown:e,onShow:i},s.name))]}),u("p",{class:"choice-note",children:[u("button",{type:"button",disabled:e.every(Boolean),onClick:()=>t(r),children:"show all columns"})," ","Your browser remembers the choice, and the address contains it."]})]})}var u3=[["*:differs","some engine differs from expected.toml"],["bullet:fail and ode:pass","one fails where another passes"],["any:crash or any:timeout","any is short for *"],["bullet*:digits<-2","some Bullet misses a tolerance by more than two digits"],["digits<0 not in-house:digits<0","somebody fails, the in-house engine does not"],["tag:top (claim:energy* or claim:*momentum*)","tags of the scenario, claims or observables; * and ? in all names"],["scenario:heavy_* columns:ode*,bullet","rows by name; only these columns (columns:-ode* leaves out)"],["columns:-in-house*","without the in-house engine"],['"not a spring"',"plain or quoted words are looked for in names and titles"]];function h3({query:n,fault:e}){let t=" ".repeat(e.at)+"^".repeat(Math.max(1,e.length));return u("div",{class:"query-fault",role:"alert",children:[u("pre",{"aria-hidden":"true",children:`${J(n)}
${t}`}),u("p",{children:["Character ",e.at+1,": ",J(M0(e.message))," All rows are shown."]})]})}function d3({onPick:n}){return u("details",{class:"query-help",children:[u("summary",{children:"How to ask"}),u("p",{children:["Terms side by side must all hold; ",u("code",{children:"or"}),", ",u("code",{children:"not"})," and parentheses do as they say."," ",u("code",{children:"ENGINE:STATUS"})," with pass (all claims), low-quality, fail, undecided, unsupported, crash, timeout, non-finite, protocol (some claim), differs, expected, none (not run);"," ",u("code",{children:"ENGINE:digits<X"})," ","with < <= > >= =. An engine means all its columns, shown or not."]}),u("ul",{children:u3.map(([e,t])=>u("li",{children:[u("button",{type:"button",onClick:()=>n(e),children:u("code",{children:e})})," ",t]},e))})]})}function kb({input:n,fault:e,onQuery:t}){let i=An().q??"";return u("div",{class:"filter",role:"search",children:[u("label",{children:["Filter ",u("kbd",{children:"/"})," ",u("input",{ref:n,type:"search",value:i,spellcheck:!1,autocomplete:"off","aria-invalid":e!==null,onInput:r=>t(r.currentTarget.value),placeholder:"bullet:fail and ode:pass"})]}),e?u(h3,{query:i,fault:e}):null,u(d3,{onPick:t})]})}var Ob="cylon-hidden-columns";function Bb(){try{let n=JSON.parse(localStorage.getItem(Ob)??"[]");return new Set(Array.isArray(n)?n.filter(e=>typeof e=="string"):[])}catch{return new Set}}function Vb(n){let e=Bb(),t=n.map(({label:i})=>!e.has(i));return t.some(Boolean)?t:n.map(()=>!0)}function zb(n,e){let t=Bb();n.forEach(({label:i},r)=>e[r]?t.delete(i):t.add(i));try{localStorage.setItem(Ob,JSON.stringify([...t]))}catch{}}var f3={ArrowUp:(n,e)=>[n-1,e],ArrowDown:(n,e)=>[n+1,e],ArrowLeft:(n,e)=>[n,e-1],ArrowRight:(n,e)=>[n,e+1],PageUp:(n,e)=>[n-10,e],PageDown:(n,e)=>[n+10,e],Home:n=>[n,0],End:(n,e,t,i)=>[n,i-1]};function yd(n,e){return Math.min(e-1,Math.max(0,n))}function Hb(n,e,t){let i=Ht(null),r=Ht([0,0]),s=(o,a)=>{let l=(h,f)=>i.current?.querySelector(`[data-row='${h}'][data-column='${f}']`)??null,c=l(o,a);return c?(l(...r.current)?.setAttribute("tabindex","-1"),c.setAttribute("tabindex","0"),r.current=[o,a],c):null};return wi(()=>{i.current?.querySelectorAll('[data-row][tabindex="0"]').forEach(o=>o.setAttribute("tabindex","-1")),s(yd(r.current[0],n),yd(r.current[1],e))}),wi(()=>{let o=i.current;if(!o)return;let a=c=>{let h=f3[c.key];if(!h||!(c.target instanceof HTMLElement)||c.target.dataset.row===void 0||c.altKey||c.metaKey||c.shiftKey)return;let[f,d]=h(...r.current,n,e);c.ctrlKey&&(f=c.key==="Home"?0:c.key==="End"?n-1:f),f=yd(f,n),d=yd(d,e),c.preventDefault();let p=s(f,d);p?p.focus():t()},l=c=>{let{row:h,column:f}=c.target instanceof HTMLElement?c.target.dataset:{};h!==void 0&&f!==void 0&&s(Number(h),Number(f))};return o.addEventListener("keydown",a),o.addEventListener("focusin",l),()=>{o.removeEventListener("keydown",a),o.removeEventListener("focusin",l)}},[n,e,t]),i}function Zm({name:n,columns:[e,t]},i){return t===void 0&&i[e].label===n}function Km(n,e){return Tb(n)&&n.some(t=>!Zm(t,e))?2:1}function Wb({families:n}){return u(Oe,{children:[u("colgroup",{class:"names"}),n.map(({name:e,columns:t})=>u("colgroup",{span:t.length},e))]})}function Gb({column:n,starts:e,rows:t}){return u("th",{scope:"col",class:e?"starts":void 0,rowSpan:t,children:[u(Wn,{text:n.label}),n.substeps>1?u("span",{class:"title",children:hs("",n.substeps)}):null]})}function $b({families:n,columns:e}){let t=Km(n,e),i=t===1?n:n.filter(s=>!Zm(s,e)),r=u("th",{scope:"col",class:"corner",rowSpan:t,children:"scenario"});return u("thead",{children:[t===2?u("tr",{"aria-rowindex":1,children:[r,n.map(s=>Zm(s,e)?u(Gb,{column:e[s.columns[0]],starts:!0,rows:2},s.name):u("th",{scope:"colgroup",class:"family starts",colSpan:s.columns.length,children:u("span",{children:J(s.name)})},s.name))]}):null,u("tr",{"aria-rowindex":t,children:[t===1?r:null,i.flatMap(s=>s.columns.map((o,a)=>u(Gb,{column:e[o],starts:a===0,rows:1},o)))]})]})}function Xb(n){return class extends No{shouldComponentUpdate(t){return Object.keys(t).some(r=>t[r]!==this.props[r])}render(){return Vg(n,this.props)}}}var qb=200,p3=12;function m3({cell:n,row:e,column:t}){let{glyph:i}=Yn[n.worst],r=xn(n.worst)&&n.digits!==null?` ${ko(n.digits)}`:"",s=J(`${n.scenario}, ${n.engine}`),o=n.passedBy.length>0?" avoidable":"",a=n.closedForm?" =":"";return u("a",{href:Qn(Cr(n)),class:"cell",tabIndex:-1,"data-row":e,"data-column":t,"aria-label":`${s}: ${g0(n.worst,n.digits,n.differs)}${n.closedForm?", closed form":""}${o}`,children:[i+r+a+o,n.differs?u(Yr,{}):null]})}function g3(n,e){let i=[n&&(n.passedBy.length>0?"avoidable":Yn[n.worst].tone),n?.differs&&"has-differs",e&&"starts"].filter(Boolean);return i.length>0?i.join(" "):void 0}function _3({row:n,column:e}){return u("span",{class:"cell none",tabIndex:-1,"data-row":n,"data-column":e,children:u("span",{class:"unseen",children:"not run"})})}var x3=Xb(({row:n,index:e,above:t,title:i,families:r})=>{let s=0;return u("tr",{"aria-rowindex":e+t+1,children:[u("th",{scope:"row",children:[u("span",{class:"name",children:u(Wn,{text:n.label})}),i&&i!==n.label?u("span",{class:"title",children:J(i)}):null]}),r.flatMap(o=>o.columns.map((a,l)=>{let c=n.cells[a],h={row:e,column:s++};return u("td",{class:g3(c,l===0),children:c?u(m3,{cell:c,...h}):u(_3,{...h})},a)}))]})});function Yb({columns:n,families:e,rows:t,titles:i,version:r}){let[s,o]=et(qb),a=Ht(null),l=c0(()=>o(p=>p+qb),[]),c=e.reduce((p,m)=>p+m.columns.length,0),h=Km(e,n),f=Hb(t.length,c,l),d=t.length>s;return Rt(()=>{let p=()=>o(1/0);return addEventListener("beforeprint",p),()=>removeEventListener("beforeprint",p)},[]),Rt(()=>{if(!d||!a.current)return;let p=new IntersectionObserver(m=>m.some(x=>x.isIntersecting)&&l(),{rootMargin:"600px"});return p.observe(a.current),()=>p.disconnect()},[d,s]),u("div",{class:"matrix-scroll",role:"region","aria-label":"Matrix of scenarios and engines",children:[u("table",{class:c>p3?"matrix dense":"matrix",ref:f,role:"grid","aria-rowcount":t.length+h,"aria-readonly":"true",children:[u("caption",{class:"unseen",children:"Scenarios and engines; arrow keys move, Enter opens a cell, Escape comes back"}),u(Wb,{families:e}),u($b,{families:e,columns:n}),u("tbody",{children:t.slice(0,s).map((p,m)=>u(x3,{row:p,index:m,above:h,title:i.get(p.scenario)??"",families:e,version:r},`${p.scenario}\0${p.dt}`))})]}),d?u("div",{ref:a,class:"matrix-end",children:[t.length-s," more rows"," ",u("button",{type:"button",onClick:()=>o(1/0),children:"draw all"})]}):null]})}var y3={query:{kind:"all"},columns:[],engines:[]};function Jb(n,e){try{let t=Lb(n);return Nb(t.engines,e),{parsed:t,fault:null}}catch(t){if(t instanceof Zn)return{parsed:y3,fault:t};throw t}}function v3(n,e){let[t,i]=[Wm(n),Wm(e)];return i[0]-t[0]||i[1]-t[1]||i[2]-t[2]}var Zb={"":{label:"as run",compare:null},worst:{label:"worst first",compare:v3},name:{label:"by name",compare:(n,e)=>n.label.localeCompare(e.label,"en")}};function b3({rows:n}){let e=new Set(n.flatMap(t=>t.cells.map(i=>i?.worst)));return u("p",{class:"legend",children:[Mf.filter(t=>e.has(t)).map(t=>u("span",{children:[u("span",{class:`status ${Yn[t].tone}`,children:Yn[t].glyph})," ",Yn[t].meaning,";"," "]},t)),n.some(t=>t.cells.some(i=>i&&i.passedBy.length>0))?u("span",{children:[u("span",{class:"status avoidable",children:[Yn.unsupported.glyph," avoidable"]})," refused, though another engine passes;"," "]}):null,u("span",{children:[u("span",{class:"number",children:"+1.0"})," log10(allowed / measured) of the worst claim: + is better than allowed, \u2212 is worse;"," "]}),n.some(t=>t.cells.some(i=>i?.closedForm))?u("span",{children:"= no steps: the engine has the motion in closed form; "}):null,u("span",{children:[u(Yr,{})," differs from expected.toml"]})]})}function Kb({matrix:n,views:e}){let{q:t="",sort:i="",section:r=""}=An(),s=Ht(null),{parsed:o,fault:a}=Ue(()=>Jb(t,n.columns),[t,n]),l=Ue(()=>new Map([...e].map(([p,m])=>[p,m.title])),[e]),c=Ue(()=>Jm(o.columns,n.columns),[o,n]),h=Ue(()=>md(n.columns,c),[n,c]),f=Ue(()=>{let p=n.rows.filter(Ym(o.query,n.columns,e)),m=Zb[i]?.compare;return m?p.sort(m):p},[o,n,e,i]);wi(()=>{let p=m=>{let x=m.target instanceof HTMLInputElement||m.target instanceof HTMLSelectElement;m.key!=="/"||x||m.ctrlKey||m.metaKey||!s.current?.offsetParent||(m.preventDefault(),s.current.select())};return addEventListener("keydown",p),()=>removeEventListener("keydown",p)},[]);let d=p=>{an({q:p});let m=Jb(p,n.columns),x=Jm(m.parsed.columns,n.columns);!m.fault&&x.some((_,g)=>_!==c[g])&&zb(n.columns,x)};return u("section",{class:"matrix-section","aria-labelledby":"matrix-heading",children:[u("h2",{id:"matrix-heading",children:"Scenarios and engines"}),u("div",{class:"matrix-tools",children:[u(kb,{input:s,fault:a,onQuery:d}),u("label",{class:"sort",children:["Order"," ",u("select",{value:i,onChange:p=>an({sort:p.currentTarget.value}),children:Object.entries(Zb).map(([p,{label:m}])=>u("option",{value:p,children:m},p))})]}),u(Ub,{columns:n.columns,shown:c,onChange:p=>d(xd(t,n.columns,p))})]}),u("p",{class:"count",role:"status",children:[f.length," of ",n.rows.length," rows, ",c.filter(Boolean).length," of ",n.columns.length," columns",f.length===0?": nothing answers the filter":""]}),u(Yb,{columns:n.columns,families:h,rows:f,titles:l,version:`${t} ${i} ${r}`}),u(b3,{rows:n.rows})]})}var jm={status:"another status",error:"error moved by more than 10 %",new:"new",gone:"gone",scenario:"the scenario itself changed, not compared"};function jb(n){let e=new Map,t=new Map;for(let i of n){let r=[i.scenario,i.engine,i.integrator,i.dt??i.dt_text,i.claim].join("\0"),s=e.get(r)??0;e.set(r,s+1),t.set(`${r}\0${s}`,i)}return t}function S3(n,e){if(!xn(n.status)||!xn(e.status))return null;let[t,i]=[e.measured??1/0,n.measured??1/0];return t===i||Math.abs(i-t)<=.1*Math.abs(t)?null:t===0||i===0?i>t?99:-99:Math.log10(i/t)}function M3(n,e){if(!e)return{kind:"new",verdict:n,before:null,weight:0};if(n.scenario_hash!==e.scenario_hash)return{kind:"scenario",verdict:n,before:e,weight:0};if(n.status!==e.status){let i=ar(e.measured,e.allowed)-ar(n.measured,n.allowed);return{kind:"status",verdict:n,before:e,weight:1e3*(Xi(n.status)-Xi(e.status))+i}}let t=S3(n,e);return t===null?null:{kind:"error",verdict:n,before:e,weight:t}}var Qb=["status","error","gone","new","scenario"];function eS(n,e){let t=jb(e),i=[];for(let[r,s]of jb(n)){let o=M3(s,t.get(r));o&&i.push(o),t.delete(r)}for(let r of t.values())i.push({kind:"gone",verdict:r,before:r,weight:0});return i.sort((r,s)=>Qb.indexOf(r.kind)-Qb.indexOf(s.kind)||s.weight-r.weight)}function w3(n){let e=new Map;for(let i of n)e.set(i.status,(e.get(i.status)??0)+1);return[...e].sort(([i],[r])=>Xi(r)-Xi(i)).map(([i,r])=>`${r} ${i}`).join(", ")}function Qm(n){let e=n.filter(lr),t=n.filter(o=>!lr(o)&&o.status==="undecided").length,i=n.filter(o=>!lr(o)&&o.status!=="pass"&&o.status!=="undecided"),r=n.length-e.length-i.length-t,s=(o,a)=>a.length>0?`${o} (${w3(a)})`:o;return{total:n.length,differ:e,differText:s(`${e.length} ${e.length===1?"differs":"differ"}`,e),expectedText:s(`${i.length} as expected`,i)+(t>0?`, ${t} undecided`:""),passText:`${r} pass`}}function vd(n){let e=[],t=new Set([n.provenance.tolerance_scale,...n.verdicts.map(r=>r.tolerance_scale)]);t.delete(1),t.size>0&&e.push(`All tolerances are multiplied by ${[...t].join(", ")}: the verdicts are not those of the stated tolerances.`);let i=new Map;for(let r of n.verdicts)if(!r.version_listed){let s=`${r.engine} ${r.version}`,o=i.get(s)??{all:0,explained:0};++o.all,r.expected_reason!==""&&++o.explained,i.set(s,o)}for(let[r,{all:s,explained:o}]of i){let a=`${Pt(o,"verdict")} ${o===1?"is":"are"} compared with the expectations for other versions`,l=o===0?"a pass is expected":a+(o<s?", of the others a pass is expected":"");e.push(`expected.toml has no row for ${r}: ${l}.`)}return e}function eg(n,e){return`${n.scenario} / ${n.engine}${e?`, step ${li(n.dt_text)}`:""}`}function tg({verdict:n,step:e}){let t={scenario:n.scenario,engine:n.engine,integrator:n.integrator,dt:n.dt_text};return u("a",{href:Qn(Cr(t)),children:u(Wn,{text:eg(n,e)})})}function T3(n){if(!xn(n.status))return n.first_bad_step===null?"":`not finite from step ${n.first_bad_step}`;let e=_c(ar(n.measured,n.allowed));return`${xc(n)} of ${Gn(n.allowed,n.unit)}, ${e}`}function A3(n){let e=new Map;return n.forEach((t,i)=>{let r=xn(t.status)||t.status==="non-finite",s=[t.scenario,t.engine,t.integrator,t.dt_text,t.status,t.expected,t.detail,r?i:""].join("\0"),o=e.get(s);o?o.push(t):e.set(s,[t])}),[...e.values()]}function E3({group:n,step:e}){let t=n[0];return u("tr",{children:[u("th",{scope:"row",children:u(tg,{verdict:t,step:e})}),u("td",{children:[n.length>1?u("strong",{children:[n.length," claims: "]}):"",J(n.map(({claim:i})=>i).join("; "))]}),u("td",{children:u(cr,{status:t.status})}),u("td",{children:t.expected}),u("td",{class:"number",children:T3(t)}),u("td",{children:u(Nt,{text:t.detail})})]})}function tS({verdicts:n,stepped:e}){let t=Ue(()=>A3(n),[n]),{list:i,button:r}=Zi(t),s=t.length===n.length?"":` in ${Pt(t.length,"row")}`,o=`${Pt(n.length,"verdict")}${s}, worst first`;return u("div",{class:"scroll",tabIndex:0,role:"region","aria-label":o,children:[u("table",{children:[u("caption",{children:o}),u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"cell"}),u("th",{scope:"col",children:"claim"}),u("th",{scope:"col",children:"status"}),u("th",{scope:"col",children:"expected"}),u("th",{scope:"col",children:"measured of allowed"}),u("th",{scope:"col",children:"detail"})]})}),u("tbody",{children:i.map((a,l)=>u(E3,{group:a,step:e.has(a[0].scenario)},l))})]}),r]})}function C3({of:n}){let e=n.differ.length>0?"differs":"agrees";return u("p",{class:"verdict-line",children:[Pt(n.total,"verdict"),": ",u("strong",{class:e,children:n.differText}),","," ",`${n.expectedText}, ${n.passText}`]})}function R3({kind:n,verdict:e,before:t,weight:i}){if(n!=="error"||!t)return"";let r=i>0?`${Zs(-i)} digits: worse`:`${Zs(-i)} digits: better`;return`${Gn(t.measured,t.unit)} to ${Gn(e.measured,e.unit)}, ${r}`}function P3({change:n,step:e}){let{kind:t,verdict:i,before:r}=n;return u("tr",{children:[u("th",{scope:"row",children:t==="gone"?u(Wn,{text:eg(i,e)}):u(tg,{verdict:i,step:e})}),u("td",{children:J(i.claim)}),u("td",{children:jm[t]}),u("td",{children:r?u(cr,{status:r.status}):""}),u("td",{children:t==="gone"?"":u(cr,{status:i.status})}),u("td",{class:"number",children:R3(n)})]})}function I3(n){return`${n.cylon} (${n.revision}) of ${n.date}`}function L3({list:n,baseline:e,scale:t,stepped:i}){let{list:r,button:s}=Zi(n),o=Object.entries(jm).map(([a,l])=>[n.filter(c=>c.kind===a).length,l]).filter(([a])=>a>0).map(([a,l])=>`${a} ${l}`).join(", ");return u("section",{"aria-labelledby":"changes-heading",children:[u("h2",{id:"changes-heading",children:["Since the baseline, ",J(I3(e))]}),u("p",{children:n.length===0?"No status changed, no error moved by more than 10 %.":`${o}.`}),e.tolerance_scale===t?null:u("p",{class:"warnings",children:[u("strong",{children:"Warning:"})," the tolerances of the baseline were multiplied by"," ",e.tolerance_scale,", those of this run by ",t,": statuses of one are not those of the other."]}),n.length>0?u("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Changes since the baseline",children:u("table",{children:[u("thead",{children:u("tr",{children:["cell","claim","change","before","now","error"].map(a=>u("th",{scope:"col",children:a},a))})}),u("tbody",{children:r.map((a,l)=>u(P3,{change:a,step:i.has(a.verdict.scenario)},l))})]})}):null,s]})}function D3({matrix:n}){let e=n.columns.map(({label:s},o)=>({label:s,...Cb(n,o)})),t=new Set(n.rows.map(({scenario:s})=>s)).size,i=e.every(({run:s})=>s===t),r=n.rows.flatMap(({label:s,cells:o})=>o.flatMap(a=>a&&a.passedBy.length>0?[{label:s,cell:a}]:[]));return u(Oe,{children:[u("p",{class:"supported",children:["Scenes supported:"," ",i?`all ${t} by ${e.length===1?"the engine":`each of ${e.length} engines`}`:e.map(({label:s,run:o,asked:a})=>`${J(s)} ${o} of ${a}`).join(", "),"."]}),r.length>0?u("details",{class:"supported",children:[u("summary",{children:[u("strong",{children:Pt(r.length,"refusal")})," that another engine shows to be avoidable"]}),u("ul",{children:r.map(({label:s,cell:o},a)=>u("li",{children:[u("a",{href:Qn(Cr(o)),children:[J(o.engine),": ",J(s)]}),", which ",J(o.passedBy.join(", "))," ",o.passedBy.length===1?"passes":"pass"]},a))})]}):null]})}function nS({index:n,matrix:e}){let t=Ue(()=>Qm(n.results.verdicts),[n]),i=Ue(()=>vd(n.results),[n]);return u(Oe,{children:[t.total>0?u(C3,{of:t}):u("p",{class:"verdict-line",children:"No verdicts: cylon run --json FILE makes them."}),t.total>0?u(D3,{matrix:e}):null,i.length>0?u("ul",{class:"warnings","aria-label":"Warnings",children:i.map(r=>u("li",{children:[u("strong",{children:"Warning:"})," ",J(r)]},r))}):null]})}function iS({index:n}){let e=Ue(()=>yc(Qm(n.results.verdicts).differ),[n]),t=Ue(()=>n.baseline?eS(n.results.verdicts,n.baseline.verdicts):[],[n]),i=Ue(()=>Eb([...n.results.verdicts,...n.baseline?.verdicts??[]]),[n]);return u(Oe,{children:[e.length>0?u("section",{"aria-labelledby":"differ-heading",children:[u("h2",{id:"differ-heading",children:"Not as expected.toml says"}),u(tS,{verdicts:e,stepped:i})]}):null,n.baseline?u(L3,{list:t,baseline:n.baseline.provenance,scale:n.results.provenance.tolerance_scale,stepped:i}):null]})}function N3({of:n}){return n.detail||n.measured.length===0?u(Oo,{text:n.detail,label:"What the engine said"}):u("div",{class:"scroll",tabIndex:0,role:"region","aria-label":`Error of ${J(n.name)} at each step`,children:u("table",{children:[u("caption",{children:["Error at each step; allowed ",ge(n.allowed)," ",J(n.unit)]}),u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"step [s]"}),u("th",{scope:"col",children:["error [",J(n.unit),"]"]})]})}),u("tbody",{children:n.measured.map(({dt:e,error:t})=>u("tr",{children:[u("td",{class:"number",children:ge(e)}),u("td",{class:"number",children:ge(t)})]},e))})]})})}function F3({of:n}){return u("article",{"aria-label":J(n.name),children:[u("h3",{children:[J(n.engine)," ",J(n.version),": ",J(n.signature)]}),u("p",{children:["What should happen: ",u(Nt,{text:n.says}),". ",n.reason," Seen in ",n.hits," ",n.hits===1?"scene":"scenes","; first in ",J(n.found_in),"."]}),u(N3,{of:n}),n.opinions.length>0?u("p",{children:["Other engines: ",n.opinions.map(e=>`${J(e.engine)}: ${J(e.says)}`).join("; "),"."]}):null,u("details",{children:[u("summary",{children:"The least scene"}),u(Oo,{text:`${n.command}

${n.scenario}`,label:`Scene of ${J(n.name)}`})]}),n.program?u("details",{children:[u("summary",{children:["A program that shows it without Cylon; it prints ",ge(n.program.prints)," ",J(n.program.unit)]}),u(Oo,{text:`${n.program.command}

${n.program.text}`,label:`Program of ${J(n.name)}`})]}):u("p",{class:"note",children:["There is no program against the engine's own API: ",u(Nt,{text:n.no_program}),"."]})]})}function U3({of:n}){return!n.asked||n.asked.length===0?n.cards.length>0?null:u("p",{children:"No fault."}):u("ul",{children:n.asked.map(({engine:e,scenes:t,refused:i,faulty:r},s)=>u("li",{children:[J(e),": ",Pt(t,"scene"),", ",i," refused, ",r===0?"no fault":`${r} with a fault`]},s))})}function rS({index:n}){return u("section",{"aria-labelledby":"faults-heading",children:[u("h2",{id:"faults-heading",children:"Faults that were found"}),n.hunts.length===0?u("p",{class:"empty",children:["This report holds no hunt. ",u("code",{children:"cylon hunt --engine ENGINE --count N --json FILE"})," makes one; then"," ",u("code",{children:"cylon report FILE\u2026 --html REPORT"}),"."]}):null,n.hunts.map((e,t)=>u(U3,{of:e},t)),n.hunts.flatMap((e,t)=>e.cards.map(i=>u(F3,{of:i},`${t} ${i.name}`)))]})}var sS=340,bd=110,Hi={left:66,right:10,top:10,bottom:20};function k3(n){let e=Math.min(...n),t=Math.max(...n),i=(e+t)/2,r=Math.max(.58*(t-e),.05*Math.abs(i))||1;return[i-r,i+r]}function oS({of:n}){let{points:e}=n,t=e.flatMap((x,_)=>typeof x.value=="number"&&Number.isFinite(x.value)?[{i:_,value:x.value}]:[]);if(t.length===0)return u("p",{class:"note",children:"no finite values"});let i=t.map(x=>x.value),[r,s]=k3(n.scale==="ratio"?[...i,1]:i),[o,a]=[bd-Hi.bottom,sS-Hi.right],l=x=>Hi.left+(e.length>1?x/(e.length-1)*(a-Hi.left):(a-Hi.left)/2),c=x=>o-(x-r)/(s-r)*(o-Hi.top),h=Math.min(...i),f=Math.max(...i),d=ge(i[i.length-1]),p=`least ${ge(h)}, greatest ${ge(f)}, last ${d} ${n.unit}`,m=`${e.length} runs, ${p}; ${n.changes.length} change points`;return u("svg",{class:"series-plot",width:sS,height:bd,role:"img","aria-label":J(m),children:[[Hi.top,o].map((x,_)=>u("text",{x:Hi.left-5,y:x+4,"text-anchor":"end",children:ge(_===0?s:r,3)},_)),u("line",{class:"frame",x1:Hi.left,x2:a,y1:o,y2:o}),n.scale==="ratio"?u("line",{class:"anchor",x1:Hi.left,x2:a,y1:c(1),y2:c(1)}):null,n.changes.map(x=>u("g",{class:`change ${x.state}`,children:[u("line",{x1:l(x.index),x2:l(x.index),y1:Hi.top,y2:o}),u("path",{d:Bo(4,l(x.index),Hi.top,5)})]},x.id)),u("polyline",{points:t.map(x=>`${l(x.i).toFixed(1)},${c(x.value).toFixed(1)}`).join(" ")}),e.length<=60?t.map(x=>u("circle",{cx:l(x.i),cy:c(x.value),r:"2.5"},x.i)):null,u("text",{x:Hi.left,y:bd-5,children:["run ",e[0].run]}),u("text",{x:a,y:bd-5,"text-anchor":"end",children:["run ",e[e.length-1].run]})]})}var Sd=24;function O3({change:n}){return u("li",{children:[u("strong",{children:J(n.state)})," at run ",n.run," (",J(n.revision),"):"," ",J(n.sentence),n.ratio===void 0?"":`, ratio ${ge(n.ratio)}`,n.note?`; note: ${J(n.note)}`:""," ",u("span",{class:"note",children:J(n.id)})]})}function B3({of:n}){let e=n.points.filter((t,i)=>i===0||t.text!==n.points[i-1].text);return u("p",{class:"note",children:[e.slice(-6).map((t,i)=>u("span",{children:["run ",t.run,": ",u("code",{children:J(t.text??"none")}),";"," "]},i)),Pt(e.length-1,"time")," another over ",n.points.length," runs"]})}function V3(n){let e=n.points[n.points.length-1];return!e||n.scale==="text"?"":`last ${ge(e.value??null)}${n.unit&&n.unit!==n.scale?` ${n.unit}`:""}`}var z3={ratio:"ratio to the pinned binary",absolute:"absolute: another machine or load moves it",value:"value",text:"text"};function H3({of:n}){return u("li",{class:"series",children:[u("h3",{children:[J(n.cell)," ",u("span",{class:"note",children:J(n.metric)})]}),n.scale==="text"?u(B3,{of:n}):u(oS,{of:n}),u("p",{class:"note",children:[z3[n.scale],V3(n)].filter(Boolean).join("; ")}),n.changes.length>0?u("ul",{children:n.changes.map(e=>u(O3,{change:e},e.id))}):null]})}function G3(n){let e=t=>2*+(t.changes.length>0)+ +(t.scale==="ratio");return[...n].sort((t,i)=>e(i)-e(t))}function aS({index:n}){let{series:e=""}=An(),[t,i]=et(Sd),r=Ue(()=>G3(n.histories.flatMap(a=>a.series)),[n]),s=Ue(()=>{let a=So(`*${e}*`);return r.filter(l=>a(`${l.cell} ${l.metric}`))},[r,e]),o=r.filter(a=>a.changes.length>0).length;return u("section",{"aria-labelledby":"history-heading",children:[u("h2",{id:"history-heading",children:"History"}),r.length===0?u("p",{class:"empty",children:["This report holds no history. ",u("code",{children:"cylon track record"})," adds runs to it,"," ",u("code",{children:"cylon track history --json"})," prints it as JSON; then"," ",u("code",{children:"cylon report FILE\u2026 --html REPORT"}),"."]}):u(Oe,{children:[u("label",{children:["Only series that match"," ",u("input",{type:"search",value:e,onInput:a=>an({series:a.currentTarget.value}),placeholder:"spring_*/ode* error:*"})]}),u("p",{role:"status",children:[s.length," of ",r.length," series; ",o," with change points, which come first"]})]}),u("ul",{class:"series-list",children:s.slice(0,t).map(a=>u(H3,{of:a},a.series))}),s.length>t?u("button",{type:"button",onClick:()=>i(t+Sd),children:["show ",s.length-t>Sd?`${Sd} more of ${s.length-t}`:`${s.length-t} more`]}):null]})}function Md({predictions:n,fits:e}){let t=new Map,i=r=>{let s=t.get(r.experiment)??{id:r.experiment,of:r,predictions:[],fits:[]};return t.set(r.experiment,s),s};for(let r of n)i(r).predictions.push(r);for(let r of e)i(r).fits.push(r);for(let r of t.values())r.predictions.sort((s,o)=>Number(s.fitted)-Number(o.fitted));return[...t.values()]}function ng({fitted:n,set:e}){return n?"after the fit":e.length>0?`with ${e.join(", ")}`:"model's own values"}function lS({predictions:n,fits:e}){let t=[];for(let r of n)for(let s of r.engines)t.push({engine:s.engine,values:ng(r),score:s});for(let{judged:r}of e)for(let{engine:s,before:o,after:a}of r)o&&t.push({engine:s,values:"before the fit, on its judging runs",score:o}),a&&t.push({engine:s,values:"after the fit, on its judging runs",score:a});return[...new Set(t.map(({engine:r})=>r))].flatMap(r=>t.filter(s=>s.engine===r))}function ig(n){return"distance"in n}function kn(n,e,t,i="not known"){let r=s=>s===null?i:(e*s).toFixed(t);return n.value===null&&n.low===null?i:n.low===null&&n.high===null?r(n.value):`${r(n.value)} [${r(n.low)}, ${r(n.high)}]`}function cS(n,e,t){return e===null?`${ge(n)}, not known`:`${ge(n)} [${ge(e)}, ${ge(t)}]`}function W3({fit:n}){return n.failure?u("tr",{children:[u("th",{scope:"row",children:J(n.engine)}),u("td",{colSpan:4,children:["no fit: ",J(n.failure)]})]}):u(Oe,{children:n.parameters.map(e=>u("tr",{children:[u("th",{scope:"row",children:J(n.engine)}),u("td",{children:J(e.name)}),u("td",{class:"number",children:cS(e.value,e.low,e.high)}),u("td",{class:"number",children:cS(e.value,e.low_between_runs,e.high_between_runs)}),u("td",{children:e.at_bound?"at its bound":""})]},e.name))})}function $3(n,e){return e.flatMap((i,r)=>Math.abs(i)>.1?[`${i<0?"-":"+"} ${Math.abs(i).toFixed(2)} ${J(n.parameters[r]?.name??"")}`]:[]).join(" ").replace(/^\+ /,"")}function X3({fit:n}){let e=n.misfit_p<.05?"the model and the stated uncertainties do not explain it":"as the stated uncertainties say";return u("li",{children:[J(n.engine),", on ",Pt(n.fitted_on.length,"run"),": misfit of a number"," ",ge(n.misfit/n.numbers,3),": ",e," (p = ",ge(n.misfit_p,2),");"," ",n.settled?"settled":"not settled"," after ",Pt(n.rounds,"round"),n.cannot_be_told_apart.map(({weights:t,error:i},r)=>u("span",{children:["; cannot be told apart along ",$3(n,t)," (standard error ",ge(i,2)," of the ranges)"]},r))]})}function uS({of:n}){return u(Oe,{children:[u("div",{class:"scroll",tabIndex:0,role:"region","aria-label":`Fits to ${J(n.title)}`,children:u("table",{children:[u("caption",{children:["Parameters of greatest likelihood, from windows of ",ge(n.horizon)," s; ",n.runs," of ",n.measured_runs," runs used"]}),u("thead",{children:u("tr",{children:["engine","parameter","value, if the uncertainties are right","between runs","remarks"].map(e=>u("th",{scope:"col",children:e},e))})}),u("tbody",{children:n.fits.map((e,t)=>u(W3,{fit:e},t))})]})}),u("ul",{children:[n.fits.filter(e=>!e.failure).map((e,t)=>u(X3,{fit:e},t)),n.likelier.map(e=>u("li",{children:["Likelier, on runs that were not fitted: ",J(e.one)," in ",e.runs_of_one,", ",J(e.other)," in"," ",e.runs_of_other,": ",u("strong",{children:J(e.likelier)})," (p = ",ge(e.p,2),")"]},e.other))]})]})}function wd(n){let e=Ht(null),[t,i]=et(n);return Rt(()=>{if(!e.current)return;let r=new ResizeObserver(([s])=>s&&i(Math.max(240,Math.floor(s.contentRect.width))));return r.observe(e.current),()=>r.disconnect()},[]),[e,t]}var Kl=150,pi={left:128,right:16,top:8,bottom:30};function q3({each:n,flight:e,rest:t}){let i=r=>r!==null;return[{label:"from free flight",values:n.map(r=>r.flight).filter(i),mean:e},{label:"from heights at rest",values:n.flatMap(({height:r,half:s})=>r!==null&&s?[r/s]:[]),mean:t}].filter(({values:r})=>r.length>0)}function Y3({of:n,title:e}){let[t,i]=wd(900),r=[...n.flatMap(({values:m})=>m),1],s=Math.max(...r)-Math.min(...r)||.01,[o,a]=[Math.min(...r)-.05*s,Math.max(...r)+.05*s],l=m=>pi.left+(m-o)/(a-o)*(i-pi.left-pi.right),c=(Kl-pi.top-pi.bottom)/n.length,h=n.map(({label:m,mean:x})=>`${m}: mean ${kn(x,1,4)}`).join("; "),f=10**Math.floor(Math.log10(a-o)),d=(a-o)/f>4?f:f/2,p=[];for(let m=Math.ceil(o/d);m*d<=a;++m)p.push(m*d);return u("div",{ref:t,class:"dots",children:u("svg",{width:i,height:Kl,role:"img","aria-label":J(`Lengths of ${e}, measured over true. ${h}`),children:[p.map(m=>u("g",{children:[u("line",{class:"grid",x1:l(m),x2:l(m),y1:pi.top,y2:Kl-pi.bottom}),u("text",{x:l(m),y:Kl-pi.bottom+16,"text-anchor":"middle",children:ge(m,5)})]},m)),u("line",{class:"one",x1:l(1),x2:l(1),y1:pi.top,y2:Kl-pi.bottom}),n.map(({label:m,values:x,mean:_},g)=>u("g",{children:[u("text",{x:pi.left-8,y:pi.top+(g+.5)*c+4,"text-anchor":"end",children:m}),x.map((v,E)=>u("circle",{cx:l(v),cy:pi.top+(g+.15+.7*(E*.618034%1))*c,r:"2"},E)),_.low!==null&&_.high!==null?u("line",{class:"mean",x1:l(_.low),x2:l(_.high),y1:pi.top+(g+.5)*c,y2:pi.top+(g+.5)*c}):null]},m))]})})}var rg=n=>n.reduce((e,t)=>e+t,0)/n.length;function J3({each:n}){let e=[...new Set(n.map(({side:t})=>t))].filter(t=>t!==0).sort((t,i)=>t-i);return e.length===0?null:u("table",{children:[u("caption",{children:"Heights of the centre at rest, by the side of the body that is up"}),u("thead",{children:u("tr",{children:["side up","runs","height [mm]","half of the thickness [mm]","measured/true"].map(t=>u("th",{scope:"col",children:t},t))})}),u("tbody",{children:e.map(t=>{let i=n.filter(o=>o.side===t&&o.height!==null&&o.half!==null),[r,s]=[rg(i.map(o=>o.height)),rg(i.map(o=>o.half))];return u("tr",{children:[u("th",{scope:"row",children:[t>0?"+":"-","xyz"[Math.abs(t)-1]]}),u("td",{class:"number",children:i.length}),u("td",{class:"number",children:(1e3*r).toFixed(2)}),u("td",{class:"number",children:(1e3*s).toFixed(2)}),u("td",{class:"number",children:(r/s).toFixed(4)})]},t)})})]})}function Z3({of:n}){let e=Ue(()=>n.drawn.runs.flatMap(({run:i,time:r,off_the_fall:s=[]},o)=>s.length>0?[{label:`run ${i}`,style:o,time:r.slice(0,s.length),value:s.map(a=>1e3*a)}]:[]),[n]),t=Ue(()=>new Ms([0,Math.max(...e.map(({time:i})=>i[i.length-1]),.001)],0),[e]);return e.length===0?null:u("figure",{children:[u(As,{curves:e,label:Cs("Heights in free flight less the fall of the model",e,"mm"),axis:"off the fall [mm]",log:!1,cursor:t,number:ge,height:200}),u("figcaption",{children:u(Es,{curves:e,cursor:t,log:!1,unit:"mm",caption:"Heights in free flight less the fall of the model"})})]})}var hS=({low:n,high:e})=>n!==null&&e!==null&&n<=1&&1<=e?"1 is inside the interval":"1 is outside the interval";function dS({of:n}){let{lengths:e}=n;if(!e)return null;let t=e.each.flatMap(({roughness:r})=>r===null?[]:[r]),i=q3(e);return u("section",{"aria-labelledby":"lengths-heading",children:[u("h4",{id:"lengths-heading",children:"What the data say of their lengths"}),u("ul",{children:[u("li",{children:["Free flight: a fall of ",kn(e.flight,e.gravity,3)," m/s\xB2, where it is"," ",ge(e.gravity),"; measured over true ",kn(e.flight,1,4)," in ",e.flight.runs," runs:"," ",hS(e.flight),t.length>0?`. Heights lie ${ge(1e3*rg(t),2)} mm off a parabola of any fall (mean of root mean squares)`:"","."]}),u("li",{children:["Rest: the centre lies ",kn(e.height,1e3,2)," mm up; measured over true"," ",kn(e.rest,1,4)," in ",e.rest.runs," runs: ",hS(e.rest),e.tilt===null?"":`. There the measured side is tilted by ${ge(1e3*e.tilt,3)} mrad (root mean square)`,"."]})]}),i.length>0?u(Y3,{of:i,title:n.title}):null,u("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Heights at rest by side",children:u(J3,{each:e.each})}),u(Z3,{of:n})]})}var K3=0;function fS(n,{position:e,orientation:t}){return{time:Float32Array.from(n),position:Float32Array.from(e),orientation:Float32Array.from(t)}}function j3(n){return n==="m"?[1e3,"mm"]:[1,n]}var jl=(n,e)=>n.map(t=>e*t),mS=(n,e)=>n.map((t,i)=>t-e[i]);function Td({prediction:n,at:e},t){let i=n.engines[t]?.drawn[e];return i&&!i.failure?i:null}function gS(n,e,t,i){let[r,s]=[n.low[e],n.high[e]];if(!r||!s)return null;let o=a=>jl(i?mS(a,i):a,t);return{low:o(r),high:o(s)}}function Q3(n,e,t){let{prediction:i,run:r,engine:s}=n,{time:o}=r,a=[{label:"measured",style:K3,time:o,value:jl(r.measured[e],t)}];return i.engines.forEach(({engine:l},c)=>{let h=Td(n,c);if(!h)return;let f=c===s?gS(h,e,t,null):null;a.push({label:l,style:c+1,faint:c!==s,time:o,value:jl(h.predicted[e],t),band:f})}),a}function eI(n,e,t){let{prediction:i,run:r,engine:s}=n;return i.engines.flatMap(({engine:o},a)=>{let l=Td(n,a);if(!l)return[];let c=l.predicted[e],h=a===s?gS(l,e,t,c):null,f=jl(mS(r.measured[e],c),t);return[{label:`measured less ${o}`,style:a+1,faint:a!==s,time:r.time,value:f,band:h}]})}function tI(n){return n.prediction.engines.flatMap(({engine:e},t)=>{let i=Td(n,t);if(!i||i.turn.length===0)return[];let r=jl(i.turn,180/Math.PI);return[{label:e,style:t+1,faint:t!==n.engine,time:n.run.time,value:r}]})}function pS({title:n,axis:e,unit:t,curves:i,cursor:r}){return i.length===0?null:u("figure",{children:[u(As,{curves:i,label:Cs(n,i,t),axis:e,log:!1,cursor:r,number:ge,height:210}),u("figcaption",{children:u(Es,{curves:i,cursor:r,log:!1,unit:t,caption:n})})]})}function nI({chosen:n,cursor:e}){let{prediction:t,run:i,engine:r}=n,s=Td(n,r),o=Ue(()=>new Na,[]),a=Ue(()=>s?{bodies:fS(i.time,s.predicted_motion),ghost:fS(i.time,s.measured_motion)}:null,[s,i]),l=Ue(()=>a?wc(a.ghost,[a.bodies]):null,[a]),c=t.engines[r]?.engine??"";return!s||!a?null:u(Oe,{children:[u("div",{class:"panes",children:u(Jl,{title:`${c}, run ${i.run}`,scene:s.scene,motions:a,bounds:l,cursor:e,cameras:o,ghost:!0,trails:!0})}),u("p",{class:"note",children:["The ghost is where the data have the body. Shown is the stored frame nearest to the cursor",i.every>1?`; of the data each ${i.every}th frame is kept`:"","."]})]})}function sg({label:n,options:e,value:t,choose:i}){return u("label",{children:[n," ",u("select",{value:t,onChange:r=>i(Number(r.currentTarget.value)),children:e.map((r,s)=>u("option",{value:s,children:J(r)},s))})]})}function iI({chosen:n}){let{prediction:e,run:t,engine:i}=n,{names:r,unit:s}=e.drawn,[o,a]=j3(s),l=e.engines[i]?.engine??"",c=Ue(()=>new Ms([0,t.time[t.time.length-1]||1],0),[t]),h=Ue(()=>r.flatMap((p,m)=>[{title:`${p} of run ${t.run}, measured and predicted`,axis:`${p} [${a}]`,unit:a,curves:Q3(n,m,o)},{title:`${p} of run ${t.run}, measured less predicted`,axis:`${p}, residual [${a}]`,unit:a,curves:eI(n,m,o)}]),[e,t,i]),f=Ue(()=>tI(n),[e,t,i]),d=e.engines[i]?.drawn[n.at]?.failure;return u(Oe,{children:[u(dd,{cursor:c,frames:t.time}),d?u("p",{class:"note",children:J(`${l} has no prediction of it: ${d}`)}):null,u(nI,{chosen:n,cursor:c}),u("div",{class:"total-plots",children:[h.map(p=>u(pS,{...p,cursor:c},p.title)),u(pS,{title:`Turn of run ${t.run}, between measured and predicted orientation`,axis:"turn, residual [deg]",unit:"deg",curves:f,cursor:c})]})]})}function _S({predictions:n}){let e=n.filter(x=>x.drawn.runs.length>0&&x.engines.length>0),[t,i]=et(0),[r,s]=et(0),[o,a]=et(0),l=e[t]??e[0],c=l?.drawn.runs??[],h=Math.min(r,c.length-1),f=Math.min(o,(l?.engines.length??1)-1),d=Ue(()=>l?{prediction:l,run:c[h],at:h,engine:f}:null,[l,h,f]);if(!l||!d)return null;let p=l.members,m=100*(p-1)/(p+1);return u("section",{"aria-labelledby":"runs-heading",children:[u("h4",{id:"runs-heading",children:"Runs: measured, and predicted from the first frame"}),u("div",{class:"side-tools on-screen",children:[u(sg,{label:"values",options:e.map(ng),value:e.indexOf(l),choose:i}),u(sg,{label:"run",options:c.map(x=>x.run),value:h,choose:s}),u(sg,{label:"band and picture of",options:l.engines.map(x=>x.engine),value:f,choose:a})]}),u("p",{class:"note",children:["Runs are the first by the hashes of their names, whatever came out."," ",p>0?`Shaded: the range of ${p} predictions of ${J(l.engines[f].engine)}, a band of ${ge(m,3)} %, from a start${l.fitted?", fitted parameters":""} and surfaces that err as stated.`:"There is no band: it was predicted with --members 0."]}),u(iI,{chosen:d},`${t} ${h} ${f}`)]})}var rI=180/Math.PI,sI=["distance at rest [mm]","angle [deg]","same side up [%]","first touch, off by [ms]","its place, off by [mm]","energy lost, off by [%]"],oI=["within 0.1 rad for [s]","to the end","by the start alone [s]","exponent [1/s]"];function aI({score:n}){return ig(n)?[kn(n.distance,1e3,1),kn(n.angle,rI,1),kn(n.same_side,100,1),kn(n.impact,1e3,2),n.place?kn(n.place,1e3,1):"",kn(n.loss,100,1)]:[kn(n.held,1,3,"the end"),`${n.to_the_end} of ${n.runs-n.failed}`,kn(n.expected,1,3,"the end"),kn(n.exponent,1,2)]}function lI({row:n,width:e}){let{score:t}=n,i=t.failed===t.runs;return u("tr",{children:[u("th",{scope:"row",children:J(n.engine)}),u("td",{children:J(n.values)}),u("td",{class:"number",children:t.runs-t.failed}),i?u("td",{colSpan:e+2,children:["no prediction: ",J(t.first_failure)]}):u(Oe,{children:[aI(n).map((r,s)=>u("td",{class:"number",children:r},s)),u("td",{class:"number",children:t.covered.runs>0?kn(t.covered,100,1):""}),u("td",{children:t.covered.runs>0?t.band:""})]})]})}function xS({rows:n,title:e}){let t=n[0];if(!t)return null;let i=ig(t.score)?sI:oI;return u("div",{class:"scroll",tabIndex:0,role:"region","aria-label":`Scores of ${J(e)}`,children:u("table",{children:[u("caption",{children:"Predictions from the first frame; medians over runs with intervals of 95 %"}),u("thead",{children:u("tr",{children:["engine","values","runs",...i,"inside the band [%]","90 to 98 %"].map(r=>u("th",{scope:"col",children:r},r))})}),u("tbody",{children:n.map((r,s)=>u(lI,{row:r,width:i.length},s))})]})})}function cI({of:n}){let e=[["source",n.source],["licence",n.licence],["instrument",n.instrument],["runs",String(n.measured_runs)]];return u(Oe,{children:[u("dl",{class:"facts",children:e.map(([t,i])=>i?u("div",{children:[u("dt",{children:t}),u("dd",{children:u(Nt,{text:i})})]},t):null)}),n.known.length>0?u(Oe,{children:[u("p",{children:"What is known of the data, and wrong with them:"}),u("ul",{children:n.known.map((t,i)=>u("li",{children:u(Nt,{text:t})},i))})]}):null]})}function uI({of:n}){let{kinematics:e,coordinates:t}=n;if(!e)return null;let i=t==="chain",r=[{what:"positions",over:"velocities",slope:e.velocity},{what:i?"angles":"orientations",over:i?"rates":"angular velocities",slope:e.spin}].filter(({slope:s})=>s.value!==null);return r.length===0?null:u(Oe,{children:[u("p",{children:"Columns of the data against each other, steps from frame to frame over velocities:"}),u("ul",{children:r.map(({what:s,over:o,slope:a})=>u("li",{children:[s," ",kn(a,1,3)," of ",o,a.goes_together==="no"?u(Oe,{children:[": ",u("strong",{children:"they do not go together; check columns, units, axes and rate"})]}):null]},s))})]})}function hI({set:n}){let e=n.predictions.flatMap(({nearer:t=[]})=>t);return e.length===0?null:u("ul",{children:e.map((t,i)=>u("li",{children:["Nearer at rest: ",J(t.one)," in ",t.runs_of_one," runs, ",J(t.other)," in ",t.runs_of_other,":"," ",u("strong",{children:J(t.nearer)})," (p = ",ge(t.p,2),", sign test, Holm)"]},i))})}function dI({set:n}){let{title:e}=n.of,t=n.predictions.find(r=>r.lengths),i=n.predictions.find(r=>r.kinematics);return u("article",{"aria-label":J(e),children:[u("h3",{children:J(e)}),u(cI,{of:n.of}),i?u(uI,{of:i}):null,u("h4",{children:"Predictions"}),u(xS,{rows:lS(n),title:e}),u(hI,{set:n}),n.fits.length>0?u("h4",{children:"Fits"}):null,n.fits.map((r,s)=>u(uS,{of:r},s)),t?u(dS,{of:t}):null,u(_S,{predictions:n.predictions})]})}function yS({index:n}){let{data:e}=An(),t=Md(n),i=t.find(({id:r})=>r===e)??t[0];return u("section",{children:[u("h2",{children:"Measured motions"}),u("p",{class:"note",children:["Validation: a model of a real thing, with its parameters, on an engine, against what was measured. No engine is judged alone. Where an interval does not decide, the answer is ",u("em",{children:"undecided"}),"."]}),t.length>1?u("p",{children:u("label",{children:["data set"," ",u("select",{value:i?.id,onChange:r=>an({data:r.currentTarget.value}),children:t.map(({id:r,of:s})=>u("option",{value:r,children:J(s.title)},r))})]})}):null,i?u(dI,{set:i},i.id):u("p",{class:"empty",children:"The report has no measured motions."})]})}function vS({ratio:n,low:e,high:t,tau:i}){let r=Math.log1p(i),s=Math.max(3*r,...[e,t,n].filter(c=>c>0&&Number.isFinite(c)).map(c=>1.1*Math.abs(Math.log(c)))),o=c=>180/2*(1+Math.max(-1,Math.min(1,Math.log(c)/s))),[a,l]=[o(Math.exp(-r)),o(Math.exp(r))];return u("svg",{class:"interval",width:180,height:18,"aria-hidden":"true",children:[u("rect",{class:"same",x:a,width:l-a,y:"0",height:18}),u("line",{class:"one",x1:180/2,x2:180/2,y1:"0",y2:18}),u("line",{class:"range",x1:o(e),x2:o(t),y1:18/2,y2:18/2}),u("circle",{cx:o(n),cy:18/2,r:"4"})]})}var og=["regressed","inconclusive","improved","changed","same","skipped"],bS={regressed:"\u2717",improved:"\u2713",same:"=",inconclusive:"?",changed:"\u2260"};function Ed(n){let e=og.indexOf(n);return e<0?og.length:e}function Ad(n){return[n.finding,...n.time?[n.time.finding]:[],...n.metrics.map(t=>t.finding)].sort((t,i)=>Ed(t)-Ed(i))[0]}function SS({finding:n}){return u("span",{class:`finding ${n}`,children:[bS[n]?`${bS[n]} `:"",J(n)]})}function fI({cell:n,tau:e}){let{time:t}=n;return t?t.ratio===null||t.low===null||t.high===null?u(Nt,{text:t.what}):u(Oe,{children:[u(vS,{ratio:t.ratio,low:t.low,high:t.high,tau:e})," ",u("span",{class:"number",children:[ge(t.ratio)," [",ge(t.low),", ",ge(t.high),"]",t.confidence===null?"":` at ${ge(100*t.confidence)} %`]}),u("br",{}),u("span",{class:"note",children:[Ln(t.baseline_seconds)," to ",Ln(t.candidate_seconds)," of ",J(t.what),t.adjusted_p===null?"":`, adjusted p ${ge(t.adjusted_p,2)}`]})]}):u(Nt,{text:n.untimed||"not timed"})}function pI({cell:n,tau:e}){let t=n.metrics.filter(i=>i.finding!=="same"&&i.sentence!=="");return u("tr",{children:[u("th",{scope:"row",children:u(Wn,{text:`${n.scenario} / ${n.engine} at ${n.dt_text}`})}),u("td",{children:u(SS,{finding:Ad(n)})}),u("td",{children:u(fI,{cell:n,tau:e})}),u("td",{class:"number",children:n.time?.pairs??""}),u("td",{children:[u(Nt,{text:n.reason}),u("ul",{class:"plain",children:t.map((i,r)=>u("li",{children:[u(SS,{finding:i.finding})," ",J(i.name),": ",u(Nt,{text:i.sentence})]},r))}),n.reproduce?u(vc,{text:n.reproduce}):null]})]})}function MS({of:n,nth:e}){let{list:t,button:i}=Zi([...n.cells].sort((o,a)=>Ed(Ad(o))-Ed(Ad(a)))),r=n.cells.map(Ad),s=[...new Set([...og,...r])].map(o=>[r.filter(a=>a===o).length,o]).filter(([o])=>o>0).map(([o,a])=>`${o} ${a}`).join(", ");return u("section",{"aria-labelledby":`comparison-${e}`,children:[u("h3",{id:`comparison-${e}`,children:[J(n.baseline)," and ",J(n.candidate)]}),u("p",{children:[J(s||"no cells"),". Ratios are candidate over baseline; within 1 \xB1"," ",ge(100*n.tau)," % (shaded) they count as the same, at \u03B1 = ",ge(n.alpha),n.gate?", as a gate over all cells":"","."]}),n.reliable?null:u("p",{class:"warnings",children:[u("strong",{children:"Warning:"})," the environment is unreliable: a build was found different from itself. No time here decides anything."]}),n.notes.length>0?u("ul",{children:n.notes.map((o,a)=>u("li",{children:u(Nt,{text:o})},a))}):null,u("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Compared cells",children:u("table",{children:[u("thead",{children:u("tr",{children:["cell","outcome","time, candidate over baseline","pairs","reason, results that changed, command"].map(o=>u("th",{scope:"col",children:o},o))})}),u("tbody",{children:t.map((o,a)=>u(pI,{cell:o,tau:n.tau},a))})]})}),i]})}function ds(n){return/ \((.*)\)$/.exec(n)?.[1]??""}function Cd({build:n}){return n?u("p",{class:"why",children:J(n)}):null}function Rd(n){let e=[...new Set(n.filter(Boolean))].sort();return e.length>0?`Costs of ${e.join(" and ")} are not those of native code and do not compare with them. `:""}function mI({cell:n}){let e=n?.verdicts[0];if(!n||!e)return null;let t=e.body_steps>0&&e.cpu_seconds>0,i=xn(n.worst)&&n.digits!==null?` ${ko(n.digits)}`:"";return u("a",{href:Qn(Cr(n)),class:"cost",children:[u("span",{class:"number",children:t?Ln(e.cpu_seconds/e.body_steps):"not timed"})," ",t&&!e.cpu_verified?u("span",{class:"why",children:"not verified "}):null,u("span",{class:`status ${Yn[n.worst].tone}`,children:[Yn[n.worst].glyph,i]})]})}function wS({verdicts:n}){let{columns:e,rows:t}=Ue(()=>_d(n),[n]),{list:i,button:r}=Zi(t),s=e.map((o,a)=>ds(t.flatMap(l=>l.cells[a]?.verdicts??[]).find(l=>l.version)?.version??""));return u("section",{"aria-labelledby":"costs-heading",children:[u("h3",{id:"costs-heading",children:"CPU time per body-step, with the digits of the worst claim"}),u("p",{class:"note",children:["Timed once, while the verdicts were made and perhaps with other runs beside it: orders of magnitude."," ",u("em",{children:"not verified"}),": the CPU time of the engine's process does not confirm what it tells, as in short runs, where requests and samples cost more than steps."," ",J(Rd(s)),"To decide between builds there is ",u("code",{children:"cylon track compare"}),", between engines and integrators"," ",u("code",{children:"cylon trade"}),"."]}),u("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"CPU time per body-step",children:u("table",{class:"costs",children:[u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"scenario"}),e.map((o,a)=>u("th",{scope:"col",children:[u(Wn,{text:o.label}),u(Cd,{build:s[a]??""})]},o.label))]})}),u("tbody",{children:i.map(o=>u("tr",{children:[u("th",{scope:"row",children:u(Wn,{text:o.label})}),o.cells.map((a,l)=>u("td",{children:u(mI,{cell:a})},l))]},o.label))})]})}),r]})}function TS({index:n}){return u("section",{"aria-labelledby":"performance-heading",children:[u("h2",{id:"performance-heading",children:"Performance"}),n.comparisons.length===0?u("p",{class:"empty",children:["This report holds no comparison of builds."," ",u("code",{children:"cylon track compare --baseline WHAT --json FILE"})," makes one; then"," ",u("code",{children:"cylon report FILE\u2026 --html REPORT"}),"."]}):null,n.comparisons.map((e,t)=>u(MS,{of:e,nth:t},t)),u(wS,{verdicts:n.results.verdicts})]})}var gI=[["cylon","Cylon"],["revision","revision"],["compiler","compiler"],["flags","flags"],["machine","machine"],["os","operating system"],["date","date"],["command_line","command"],["tolerance_scale","tolerances times"]];function ag({of:n,title:e}){return u(Oe,{children:[u("h3",{children:e}),u("dl",{class:"facts",children:n.map(([t,i])=>i?u("div",{children:[u("dt",{children:t}),u("dd",{children:u(Nt,{text:i})})]},t):null)})]})}function lg(n){return gI.map(([e,t])=>[t,String(n?.[e]??"")])}function _I({series:n}){let e=n.flatMap(o=>o.points).sort((o,a)=>o.run-a.run),[t,i]=[e[0],e[e.length-1]],r=o=>o?`${o.run}, revision ${o.revision}, ${o.date}`:"",s=n.flatMap(o=>(o.versions??[]).map(a=>`${o.engine} ${a}`));return[["series",String(n.length)],["first run",r(t)],["last run",r(i)],["engines",[...new Set(s)].join(", ")]]}function xI(n){return[["baseline",n.baseline],["candidate",n.candidate],["cells",String(n.cells.length)],["environment",n.reliable?"":"unreliable: a build was found different from itself"]]}function yI(n){let e=(n.asked??[]).map(({engine:i,scenes:r})=>`${i} in ${Pt(r,"scene")}`),t=new Set(n.cards.map(({engine:i,version:r})=>`${i} ${r}`));return[["asked",e.join(", ")],["with a fault",[...t].join(", ")]]}function AS(n){let e=n.format==="cylon-prediction/1"?[["hash of the model",n.model??""],["step [s]",ge(n.step)],["engines",n.engines.map(({engine:t})=>t).join(", ")]]:[["engines",n.fits.map(({engine:t})=>t).join(", ")]];return[["data",n.title],["source",n.source],["licence",n.licence],["hash of the data",n.experiment],...e]}function vI(n){let e=(t,i)=>i.map((r,s)=>({title:`${t}, file ${s+1}`,of:r}));return[...e("Speed against accuracy",n.trades.map(({provenance:t})=>lg(t))),...e("Comparison of builds",n.comparisons.map(xI)),...e("History",n.histories.map(_I)),...e("Hunt",n.hunts.map(yI)),...e("Prediction",n.predictions.map(AS)),...e("Fit",n.fits.map(AS))]}function bI(n){let e=new Map;for(let t of n){let i=[t.engine,t.version,t.precision,t.path,t.gyroscopic,t.integrator].join("\0"),r=e.get(i);r?++r.verdicts:e.set(i,{first:t,verdicts:1})}return[...e.values()]}function SI({verdicts:n}){let e=Ue(()=>bI(n),[n]);return u("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Engines",children:u("table",{children:[u("caption",{children:"Engines, one row per version, precision, path, gyroscopic mode and integrator"}),u("thead",{children:u("tr",{children:["engine","version","precision","path","gyroscopic","integrator","verdicts"].map(t=>u("th",{scope:"col",children:t},t))})}),u("tbody",{children:e.map(({first:t,verdicts:i},r)=>u("tr",{children:[u("th",{scope:"row",children:J(t.engine)}),u("td",{children:[J(t.version),t.version_listed?"":" (unlisted)"]}),u("td",{children:J(t.precision)}),u("td",{children:J(t.path)}),u("td",{children:J(t.gyroscopic)}),u("td",{children:J(t.integrator)}),u("td",{class:"number",children:i})]},r))})]})})}function MI({verdicts:n}){let e=Ue(()=>[...new Map(n.map(t=>[t.scenario,t.scenario_hash]))],[n]);return u("details",{children:[u("summary",{children:[Pt(e.length,"scenario"),": content hashes"]}),u("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Hashes of the scenarios",children:u("table",{children:[u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"scenario"}),u("th",{scope:"col",children:"hash"})]})}),u("tbody",{children:e.map(([t,i])=>u("tr",{children:[u("th",{scope:"row",children:J(t)}),u("td",{children:u("code",{children:J(i)})})]},t))})]})})]})}function ES({index:n}){let e=vd(n.results);return u("section",{"aria-labelledby":"provenance-heading",children:[u("h2",{id:"provenance-heading",children:"Provenance"}),u("p",{children:e.length>0?e.map(J).join(" "):"No warnings."}),n.omitted_traces?u("p",{children:J(n.omitted_traces)}):null,n.results.verdicts.length>0?u(ag,{of:lg(n.results.provenance),title:"This run"}):null,n.baseline?u(ag,{of:lg(n.baseline.provenance),title:"Baseline"}):null,vI(n).map(t=>u(ag,{...t},t.title)),n.results.verdicts.length>0?u(Oe,{children:[u(SI,{verdicts:n.results.verdicts}),u(MI,{verdicts:n.results.verdicts})]}):null]})}function Pd(n,e,{scenario:t}){return n.length>1?`${t} (${e+1})`:t}function cg({provenance:n}){let e=/ (matrix|trade)(?= |$)/.exec(n?.command_line??"")?.[1];return e?`cylon ${e}`:""}function CS({measures:n,by:e,cells:t}){let i=n.find(r=>r.name===e);return t&&i?{measure:i,cells:t}:null}function wI(n,e){let t=i=>[i.engine,i.integrator,i.dt_text,i.tolerance??""].join("\0");return new Map(n.times.filter(i=>i.scenario===e.scenario).map(i=>[t(i),i.cpu_seconds_per_second]))}function TI(n,e,t){let i=n.series[e.series],r=e.reach.map(({error:s,point:o,coarsest_tried:a,why:l})=>{let c=o===null?null:i.points[o],h=c?[i.engine,i.integrator,c.dt_text,c.tolerance??""].join("\0"):"";return{error:s,step:c?.dt??null,tolerance:c?.tolerance??null,cost:t.get(h)??null,coarsestTried:a,why:l}});return{engine:i.engine,version:i.version,integrator:i.integrator,order:i.observed_order,closedForm:i.closed_form??!1,adaptive:i.adaptive,substeps:i.substeps??1,refusal:e.refusal,avoidable:e.avoidable,reach:r,errors:i.points.map(s=>({dt:s.dt,error:s.errors[n.by??""]??null}))}}function AI(n,e,t){let i=e.filter(({scenario:o})=>o===n.scenario);if(i.length===1)return"";let r=cg(t[n.file]),s=i.filter(({file:o})=>cg(t[o])===r).length===1;return r&&s?r:`${r||"file"} (${n.file+1})`}function ug(n){return new Set(n.flatMap(e=>e.tables.filter(CS).map(({scenario:t})=>t))).size}function RS(n){let e=[],t=new Map,i=[];for(let[r,s]of n.entries())for(let o of s.tables){let a=CS(o);if(!a)continue;let{measure:l}=a,c=wI(s,o),h=a.cells.map(f=>TI(o,f,c));for(let{engine:f,version:d}of h)e.includes(f)||e.push(f),d&&t.set(f,ds(d));i.push({scenario:o.scenario,file:r,sweep:Pd(n,r,o),source:"",measure:`${l.name} against ${l.against}`,cells:new Map(h.map(f=>[f.engine,f]))})}for(let r of i)r.source=AI(r,i,n);return{engines:e,builds:t,rows:i,scenarios:ug(n)}}function PS(n){return/^in-house(-float)?(\/|$)/.test(n)}function IS(n,e){let t=n.errors.find(i=>i.dt<=e*1.000000001);return!t||t.error===null?null:{dt:t.dt,digits:Math.min(16,-Math.log10(Math.max(t.error,1e-16)))}}var LS=[.01,.001,1e-4];function EI(n,e){return n.closedForm?"no steps":e.tolerance!==null?`tolerance ${ge(e.tolerance,2)}`:hs(`${e.coarsestTried?"\u2265 ":""}${Ln(e.step)}`,n.substeps)}function CI({cell:n,reach:e}){let t=e.step!==null;return u("tr",{class:t?void 0:"not-reached",children:[u("th",{scope:"row",children:ge(e.error,1)}),u("td",{children:t?EI(n,e):"not reached"}),u("td",{class:"number",children:t&&e.cost!==null?`${Ln(e.cost)}/s`:""})]})}function RI(n){return n.closedForm?"closed form":n.adaptive?"chooses its steps":n.order===null?"no order seen":`order ${n.order.toFixed(2)}`}function DS({cell:n}){return u(Oe,{children:[u("strong",{children:n.avoidable?"refused, avoidable":"refused"}),u("p",{class:"why",children:[u(qi,{text:n.avoidable?n.refusal.replace(/\.$/,""):n.refusal}),n.avoidable?`; ${J(n.avoidable)} can`:""]})]})}function PI({cell:n}){if(n.refusal)return u(DS,{cell:n});let e=n.reach.find(t=>t.step===null);return u(Oe,{children:[u("table",{children:u("tbody",{children:n.reach.map(t=>u(CI,{cell:n,reach:t},t.error))})}),u("p",{class:"why",children:[RI(n),e?u(qi,{text:`; ${ge(e.error,1)}: ${e.why}`}):null]})]})}function II({cell:n,dt:e}){if(n.refusal)return u(DS,{cell:n});if(n.closedForm)return u("span",{class:"why",children:"closed form"});if(n.adaptive)return u("span",{class:"why",children:"chooses its steps"});let t=IS(n,e);return t?u(Oe,{children:[u("span",{class:"number",children:t.digits.toFixed(1)})," ",u("span",{class:"why",children:["at ",hs(Ln(t.dt),n.substeps)]})]}):u("span",{class:"why",children:"no finite error"})}function LI({matrix:n,engines:e,at:t}){return u("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Steps by scenario and engine",children:u("table",{class:"steps",children:[u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"scenario"}),e.map(i=>u("th",{scope:"col",children:[J(i),u(Cd,{build:n.builds.get(i)??""})]},i))]})}),u("tbody",{children:n.rows.map((i,r)=>u("tr",{children:[u("th",{scope:"row",children:[u("a",{href:Qn({...Ss("trade"),trade:i.sweep}),children:u(Wn,{text:i.scenario})}),i.source?u("p",{class:"why",children:["of ",i.source]}):null,u("p",{class:"why",children:u(Wn,{text:i.measure})})]}),e.map(s=>{let o=i.cells.get(s);return u("td",{class:o?.avoidable?"avoidable":void 0,children:o?t===null?u(PI,{cell:o}):u(II,{cell:o,dt:t}):"not run"},s)})]},r))})]})})}function NS({index:n}){let{at:e="",ours:t=""}=An(),i=Ue(()=>RS(n.trades),[n]),r=i.engines.filter(l=>!PS(l)),s=r.length>0&&r.length<i.engines.length,o=s&&t!=="yes"?r:i.engines,a=LS.find(l=>String(l)===e)??null;return u("section",{"aria-labelledby":"steps-heading",children:[u("h2",{id:"steps-heading",children:"Which step an engine needs"}),i.rows.length===0?u("p",{class:"empty",children:["This report holds no sweep. ",u("code",{children:"cylon matrix --json FILE"})," makes one; then"," ",u("code",{children:"cylon report FILE\u2026 --html REPORT"}),"."]}):u(Oe,{children:[u("div",{class:"choice",children:[u("label",{children:["show"," ",u("select",{value:a===null?"":e,onChange:l=>an({at:l.currentTarget.value}),children:[u("option",{value:"",children:"the coarsest step that meets an error"}),LS.map(l=>u("option",{value:String(l),children:["digits at ",Ln(l)]},l))]})]}),s?u("label",{children:[u("input",{type:"checkbox",checked:t==="yes",onChange:()=>an({ours:t==="yes"?"":"yes"})})," ","with the in-house engine"]}):null]}),u("p",{class:"count",role:"status",children:[Pt(i.scenarios,"scenario"),", ",Pt(o.length,"engine")]}),u(LI,{matrix:i,engines:o,at:a}),u("p",{class:"note",children:[a===null?"A line says: relative error; the coarsest of the tried steps that meets it, as the next finer one does; CPU time per simulated second. \u2265: no coarser step was tried. ":"Digits are -log10 of the relative error, at the coarsest tried step of at most the given one. ",a===null?J(Rd(o.map(l=>i.builds.get(l)??""))):"","no steps, closed form: the engine knows the motion as a formula of time, and a step says nothing of it. A scenario leads to its plot of error against cost."]})]})]})}function FS(n,e,t,i){return[n,e,t,i??""].join("\0")}function hg(n){return[...new Set(n.map(e=>ds(e.of.version)))].sort()}function Hr(n){return n.error!==null&&n.cost!==null&&n.error>0&&n.cost>0}function DI(n){let e=n.filter(i=>i.error!==null&&i.cost!==null);e.sort((i,r)=>i.cost-r.cost||i.error-r.error);let t=null;for(let i of e)i.onFront=t===null||i.error<t.error,i.dominatedBy="",i.onFront&&(t=i)}function US(n,e,t){let i=new Map;for(let s of n.times)s.scenario===e.scenario&&i.set(FS(s.engine,s.integrator,s.dt_text,s.tolerance),s);let r=e.series.map((s,o)=>({label:`${s.engine} ${s.integrator}`,of:s,points:s.points.map(a=>{let l=i.get(FS(s.engine,s.integrator,a.dt_text,a.tolerance));return{series:o,dt:a.dt,dtText:a.dt_text,tolerance:a.tolerance,error:a.errors[t]??null,cost:l?.cpu_seconds_per_second??null,perBodyStep:l?.seconds_per_body_step??null,status:a.status,reason:a.reason,onFront:l?.on_front??!1,dominatedBy:l?.dominated_by??""}})}));if(t!==e.by)for(let s of hg(r))DI(r.filter(o=>ds(o.of.version)===s).flatMap(o=>o.points));return r}function Id(n){return n.tolerance===null?li(n.dtText):`${li(n.dtText)}, tolerance ${n.tolerance}`}function kS({names:n}){return u("thead",{children:u("tr",{children:n.map(e=>u("th",{scope:"col",children:e},e))})})}function NI({of:n}){return n.floor===null?"":`${ge(n.floor)}${n.floor_is_rounding?", rounding":", not rounding"}`}function OS({list:n,hidden:e,toggle:t}){return u("div",{class:"scroll",tabIndex:0,role:"region","aria-label":"Engines and integrators",children:u("table",{children:[u("caption",{children:"Engines and integrators, with the order fitted to the errors"}),u(kS,{names:["engine and integrator","version","order declared","order fitted","floor","points drawn","remark"]}),u("tbody",{children:n.map((i,r)=>u("tr",{children:[u("th",{scope:"row",children:u("label",{children:[u("input",{type:"checkbox",class:"on-screen",checked:!e.has(r),onChange:()=>t(r)})," ",u(Rr,{style:r})," ",J(i.label)]})}),u("td",{children:J([i.of.version,i.of.precision,i.of.path,i.of.gyroscopic].filter(Boolean).join(", "))}),u("td",{class:"number",children:i.of.adaptive?"to tolerance":i.of.declared_order||""}),u("td",{class:"number",children:i.of.observed_order===null?"none":i.of.observed_order.toFixed(2)}),u("td",{class:"number",children:NI(i)}),u("td",{class:"number",children:[i.points.filter(Hr).length," of ",i.points.length]}),u("td",{children:u(Nt,{text:i.of.reason})})]},r))})]})})}function FI({status:n}){return n==="ran"?u(Oe,{children:"ran"}):u(cr,{status:n})}function Ld({list:n,points:e,caption:t}){let{list:i,button:r}=Zi(e);return e.length===0?null:u(Oe,{children:[u("div",{class:"scroll",tabIndex:0,role:"region","aria-label":t,children:u("table",{children:[u("caption",{children:[t," (",e.length,")"]}),u(kS,{names:["engine and integrator","step and tolerance","error","CPU s per s","per body-step","status","dominated by, or why not"]}),u("tbody",{children:i.map((s,o)=>u("tr",{children:[u("th",{scope:"row",children:u(Wn,{text:n[s.series].label})}),u("td",{class:"number",children:J(hs(Id(s),n[s.series].of.substeps))}),u("td",{class:"number",children:ge(s.error)}),u("td",{class:"number",children:s.cost===null?"not timed":ge(s.cost)}),u("td",{class:"number",children:Ln(s.perBodyStep)}),u("td",{children:u(FI,{status:s.status})}),u("td",{children:u(Nt,{text:s.dominatedBy||s.reason})})]},o))})]})}),r]})}function dg(n,e,t){let[i,r]=[1/0,-1/0];for(let h of n)i=Math.min(i,h),r=Math.max(r,h);i>0&&Number.isFinite(r)||([i,r]=[.1,1]);let s=Math.floor(Math.log10(i)+1e-9),o=Math.max(s+1,Math.ceil(Math.log10(r)-1e-9)),a=h=>e+(Math.log10(h)-s)/(o-s)*(t-e),l=Math.max(1,Math.ceil((o-s)*40/Math.abs(t-e))),c=[];for(let h=s;h<=o;h+=l)c.push({value:10**h,at:a(10**h),label:`1e${h}`});return{place:a,ticks:c}}var Dd=480,yi={left:62,right:14,top:12,bottom:46},UI=30;function kI({x:n,y:e,width:t,error:i}){let[r,s]=[Dd-yi.bottom,t-yi.right];return u("g",{class:"grid",children:[n.ticks.map(({at:o,label:a})=>u("g",{children:[u("line",{x1:o,x2:o,y1:yi.top,y2:r}),u("text",{x:o,y:r+16,"text-anchor":"middle",children:a})]},a)),e.ticks.map(({at:o,label:a})=>u("g",{children:[u("line",{x1:yi.left,x2:s,y1:o,y2:o}),u("text",{x:yi.left-6,y:o+4,"text-anchor":"end",children:a})]},a)),u("text",{x:(yi.left+s)/2,y:Dd-8,"text-anchor":"middle",children:"CPU seconds per simulated second"}),u("text",{transform:`translate(14 ${(yi.top+r)/2}) rotate(-90)`,"text-anchor":"middle",children:J(i)})]})}function OI({placed:n,style:e}){let{color:t,dash:i,marker:r}=Ti(e),s=`var(${t})`;return u("g",{children:[u("polyline",{points:n.map(({x:o,y:a})=>`${o.toFixed(1)},${a.toFixed(1)}`).join(" "),stroke:s,"stroke-dasharray":i.join(" ")}),n.map(({point:o,x:a,y:l},c)=>u("g",{children:[o.onFront?u("circle",{class:"front",cx:a,cy:l,r:"8"}):null,u("path",{d:Bo(r,a,l,4.5),fill:s})]},c))]})}function BI(n,e){let t=e.onFront?"nothing is both cheaper and better":e.dominatedBy&&`dominated by ${e.dominatedBy}`;return J([`${n[e.series].label} at ${Id(e)}`,`error ${ge(e.error)}`,`${ge(e.cost)} CPU s/s`,`${Ln(e.perBodyStep)} per body-step`,t].filter(Boolean).join("; "))}function BS({list:n,hidden:e,error:t,level:i,label:r}){let[s,o]=wd(900),[a,l]=et(null),{x:c,y:h,lines:f}=Ue(()=>{let p=n.flatMap(g=>g.points.filter(Hr)),m=dg(p.map(g=>g.cost),yi.left,o-yi.right),x=dg([...p.map(g=>g.error),...i?[i]:[]],Dd-yi.bottom,yi.top),_=g=>({point:g,x:m.place(g.cost),y:x.place(g.error)});return{x:m,y:x,lines:n.map(g=>g.points.filter(Hr).map(_))}},[n,o,i]),d=p=>{let m=p.currentTarget.getBoundingClientRect(),x=g=>Math.hypot(g.x-(p.clientX-m.left),g.y-(p.clientY-m.top)),_=f.flatMap((g,v)=>e.has(v)?[]:g).sort((g,v)=>x(g)-x(v))[0];l(_&&x(_)<UI?_.point:null)};return u("div",{ref:s,class:"trade-plot",children:[u("svg",{width:o,height:Dd,role:"img","aria-label":J(r),onPointerMove:d,onPointerLeave:()=>l(null),children:[u(kI,{x:c,y:h,width:o,error:t}),i?u("g",{class:"level",children:[u("line",{x1:yi.left,x2:o-yi.right,y1:h.place(i),y2:h.place(i)}),u("text",{x:o-yi.right-4,y:h.place(i)-5,"text-anchor":"end",children:["allowed ",ge(i)]})]}):null,f.map((p,m)=>e.has(m)?null:u(OI,{placed:p,style:m},m))]}),u("p",{class:"named on-screen",children:a?BI(n,a):"Point at a setting to read it; every one stands in the tables below."})]})}function VI(n){return n.flatMap((e,t)=>e.tables.map(i=>({key:Pd(n,t,i),trade:e,table:i})))}function zI(n,e,t){if(t.scale===null)return null;let i=n.filter(r=>r.scenario===e.scenario&&r.scenario_hash===e.scenario_hash&&r.observable===t.name).flatMap(r=>r.allowed!==null&&r.allowed>0&&r.unit===t.unit?[r.allowed]:[]);return i.length>0?Math.min(...i)/t.scale:null}function VS(n){let e=n.scale===null?"":`, over ${ge(n.scale)} ${n.unit}`;return`error of ${n.name}${e}, against ${n.against}`}function HI(n){return`Error against cost. ${n.map(t=>{let i=Math.min(...t.points.filter(Hr).map(r=>r.error));return`${t.label}: ${Number.isFinite(i)?`least error ${ge(i)}`:"no finite error"}`}).join(". ")}.`}function GI(n){return n===""?"Pareto front: no other setting is both faster and more accurate":`Pareto front of ${J(n)}: none of these is both faster and more accurate`}function WI({index:n,entry:e}){let{measure:t,hide:i=""}=An(),{trade:r,table:s}=e,o=s.measures.find(p=>p.name===t)??s.measures.find(p=>p.name===s.by)??s.measures[0],a=Ue(()=>US(r,s,o?.name??""),[r,s,o]),l=Ue(()=>new Set(i.split(",").filter(Boolean).map(Number)),[i]);if(!o)return u("p",{class:"empty",children:"This sweep measured no errors."});let c=p=>{let m=new Set(l);m.delete(p)||m.add(p),an({hide:[...m].join(",")})},h=a.flatMap(p=>p.points).sort((p,m)=>(p.cost??1/0)-(m.cost??1/0)),f=h.filter(p=>!Hr(p)),d=hg(a);return u(Oe,{children:[u("label",{children:["measure"," ",u("select",{value:o.name,onChange:p=>an({measure:p.currentTarget.value}),children:s.measures.map(p=>u("option",{value:p.name,children:J(p.name)},p.name))})]}),u("p",{class:"note",children:[u(qi,{text:`${VS(o)}; the reference itself is known to ${ge(o.resolution)}.`})," Truth:"," ",u(qi,{text:`${s.truth||"none"}; ${ge(s.duration)} s`}),", ",Pt(s.bodies,"body","bodies"),". Ringed (the Pareto front): no other setting is both faster and more accurate",o.name===s.by?"":" by this measure",d.length>1?", of those that are run by the same; costs of others do not compare.":".",f.length>0?` ${Pt(f.length,"setting")} cannot be drawn, because the error is 0 or not finite, or because no time was measured. The last table lists them.`:""]}),u(BS,{list:a,hidden:l,error:VS(o),level:zI(n.results.verdicts,s,o),label:HI(a)}),u(OS,{list:a,hidden:l,toggle:c}),d.map(p=>u(Ld,{list:a,points:h.filter(m=>Hr(m)&&m.onFront&&ds(a[m.series].of.version)===p),caption:GI(p)},p)),u(Ld,{list:a,points:h.filter(p=>Hr(p)&&!p.onFront),caption:"Other settings, each with one that is both faster and more accurate"}),u(Ld,{list:a,points:f,caption:"Not drawn"})]})}function zS({index:n}){let{trade:e}=An(),t=Ue(()=>VI(n.trades),[n]),i=t.find(r=>r.key===e)??t[0];return u("section",{"aria-labelledby":"trade-heading",children:[u("h2",{id:"trade-heading",children:"Speed against accuracy"}),i?u(Oe,{children:[u("label",{children:["scenario"," ",u("select",{value:i.key,onChange:r=>an({trade:r.currentTarget.value,measure:"",hide:""}),children:t.map(({key:r})=>u("option",{value:r,children:J(r)},r))})]})," ",u(WI,{index:n,entry:i},i.key)]}):u("p",{class:"empty",children:["This report holds no sweep. ",u("code",{children:"cylon trade SCENARIO --json FILE"})," makes one; then"," ",u("code",{children:"cylon report FILE\u2026 --html REPORT"}),"."]})]})}var Nd=n=>n.reduce((e,{length:t})=>e+t,0),Fd=[{id:"steps",label:"Steps",view:NS,size:n=>ug(n.trades)},{id:"matrix",label:"Verdicts",view:null,size:n=>n.results.verdicts.length},{id:"trade",label:"Speed against accuracy",view:zS,size:n=>Nd(n.trades.map(e=>e.tables))},{id:"performance",label:"Performance",view:TS,size:n=>Nd(n.comparisons.map(e=>e.cells))},{id:"history",label:"History",view:aS,size:n=>Nd(n.histories.map(e=>e.series))},{id:"faults",label:"Faults",view:rS,size:n=>n.hunts.length>0?Nd(n.hunts.map(e=>e.cards)):null,holds:n=>n.hunts.length>0},{id:"measured",label:"Measured motions",view:yS,size:n=>Md(n).length},{id:"provenance",label:"Provenance",view:ES,size:()=>null}];function Ud(n){return Fd.find(({size:e,holds:t})=>t?.(n)??e(n)!==0)}var fg={auto:{next:"light",label:"Colours: as the system"},light:{next:"dark",label:"Colours: light"},dark:{next:"auto",label:"Colours: dark"}};function $I(){let[n,e]=et(Kg());return u("button",{type:"button",class:"theme",onClick:()=>{jg(fg[n].next),e(fg[n].next)},children:fg[n].label})}function XI({index:n,open:e}){return u("nav",{"aria-label":"Parts of the report",children:u("ul",{children:Fd.map(({id:t,label:i,size:r})=>{let s=r(n);return u("li",{children:u("a",{href:Qn(Ss(t)),"aria-current":t===e?"page":void 0,children:[i,s===null?"":` (${s})`]})},t)})})})}function HS({index:n,matrix:e}){let t=An(),i=Ue(()=>new Map(n.scenarios.map(p=>[p.name,p])),[n]),r=Ud(n),s=t.q===void 0&&r?r.id:"matrix",o=[t.section,s].flatMap(p=>Fd.find(({id:m})=>m===p)??[])[0],a=p0(t),l=o.view,c=Ue(()=>a?Rb(e,a):null,[e,a?.scenario,a?.engine,a?.integrator,a?.dt]),h=Ht(null),f=a?`${a.scenario} / ${a.engine}`:o.label;Rt(()=>{document.title=J(`${f} - ${n.title}`)},[f,n]);let d=Ht(!1);return wi(()=>{d.current&&!a&&!l&&document.querySelector('.matrix [tabindex="0"]')?.focus(),d.current=a!==null}),u(Oe,{children:[u("header",{children:[u("a",{class:"skip",href:"#content",onClick:p=>{p.preventDefault(),h.current?.focus()},children:"Skip to the content"}),u("h1",{children:J(n.title)}),u($I,{}),u(nS,{index:n,matrix:e}),u(XI,{index:n,open:a?"":o.id})]}),u("main",{id:"content",ref:h,tabIndex:-1,children:[u("div",{class:a||l?"paper-only":void 0,children:[u(iS,{index:n}),u(Kb,{matrix:e,views:i})]}),!a&&l?u(l,{index:n}):null,a&&c?u(Mb,{index:n,matrix:e,cell:c,view:i.get(c.scenario)}):null,a&&!c?u("p",{role:"alert",children:["The report has no run of ",J(a.scenario)," by ",J(a.engine)," ",J(a.integrator)," at ",J(li(a.dt)),"."," ",u("a",{href:Qn(Ss("matrix")),children:"All runs"})]}):null]})]})}function qI({why:n}){return u("main",{children:[u("h1",{children:"This report cannot be read"}),u("p",{role:"alert",children:n})]})}var YI={cylon:"",revision:"",compiler:"",flags:"",machine:"",os:"",date:"",command_line:"",tolerance_scale:1};function JI(n){return n.results?n:{...n,results:{schema:1,provenance:YI,verdicts:[]}}}function ZI(n,{columns:e}){let{q:t,section:i=Ud(n)?.id??""}=Js(),r=Vb(e);t===void 0&&!r.every(Boolean)&&an({section:i,q:xd("",e,r)})}function GS(n){pc(),d0(),Yg(0).then(e=>{let t=JI(e);n.replaceChildren();let i=_d(t.results.verdicts);ZI(t,i),Xa(u(HS,{index:t,matrix:i}),n)},e=>Xa(u(qI,{why:String(e)}),n))}var WS=[["Space","play or pause"],[".","one step, then pause"],["R","reset"],["1 \u2026 9","kick body 1 \u2026 9; with Shift the other way"],["[ and ]","slower, faster"],["V, M, L","arrows of velocity, momentum, angular momentum"],["T, C, J","trails, contacts, springs and joints"],["Arrows, + and \u2212","turn and zoom the picture with the focus; with Shift move it"],["Home","frame all"],["Drag","turns the picture; on a body, pulls it by a spring. Shift or right button moves the picture"],["?","this list"]];function KI(n){let e=n.target;return e?.matches?e.matches("input:not([type=checkbox]):not([type=range]), select, textarea")?!0:n.key===" "&&e.matches("button, input, summary, a"):!1}function $S(n,e){let t=s=>()=>n.show({[s]:!n.shown[s]}),i=s=>()=>n.send({do:"speed",value:Math.min(100,Math.max(.01,n.speed*s))}),r={" ":()=>n.toggle(),".":()=>n.send({do:"step"}),r:()=>n.send({do:"reset"}),"[":i(.6666666666666666),"]":i(1.5),v:t("velocity"),m:t("momentum"),l:t("angular momentum"),t:t("trails"),c:t("contacts"),j:t("links"),"?":e};return s=>{if(s.ctrlKey||s.metaKey||s.altKey||s.defaultPrevented||KI(s))return;let o=/^(?:Digit|Numpad)([1-9])$/.exec(s.code),a=o?()=>n.kick(Number(o[1])-1,s.shiftKey):r[s.key.length===1?s.key.toLowerCase():s.key];!a||s.repeat&&s.key!=="."||(a(),s.preventDefault())}}function XS({dialog:n}){return u("dialog",{ref:n,class:"help","aria-labelledby":"help-title",children:[u("h2",{id:"help-title",children:"Keys"}),u("dl",{children:WS.map(([e,t])=>u("div",{children:[u("dt",{children:u("kbd",{children:e})}),u("dd",{children:t})]},e))}),u("form",{method:"dialog",children:u("button",{children:"Close"})})]})}var qS=["energy","momentum","angular momentum"],Od={energy:"J",momentum:"kg m/s","angular momentum":"kg m\xB2/s"},YS=["size","x","y","z"];function pg(n,e,t){if(n.status!=="running")return null;if(e==="energy")return n.energy;let i=e==="momentum"?n.momentum:n.angular_momentum;return!Array.isArray(i)||!i.every(r=>Number.isFinite(r))?null:t==="size"?Math.hypot(...i):i["xyz".indexOf(t)]}var kd=class{constructor(e=1200){this.most=e}most;samples=[];first=null;add(e,t){let i=this.samples[this.samples.length-1];i&&(e<i.t||t.length!==i.lanes.length)&&this.clear(),i&&e===i.t&&this.samples.pop();let r={t:e,lanes:t.map(({status:s,energy:o,momentum:a,angular_momentum:l})=>({status:s,energy:o,momentum:a,angular_momentum:l}))};this.first??=r,this.samples.push(r),this.samples.length>this.most&&this.samples.splice(0,Math.floor(this.most/4))}clear(){this.samples.length=0,this.first=null}times(){return this.samples.map(e=>e.t)}series(e,t,i){return this.samples.map(r=>r.lanes[e]?pg(r.lanes[e],t,i):null)}};function fs(n){if(n==null||!Number.isFinite(n))return"not finite";let e=Math.abs(n);return e!==0&&(e>=1e6||e<1e-4)?n.toExponential(5):n.toPrecision(6)}function JS(n,e){if(n==null||e==null)return[-1,1];let t=Math.max(Math.abs(n),Math.abs(e)),i=e>n?.08*(e-n):t>0?.001*t:1;return[n-i,e+i]}var ZS=[.3/Math.hypot(.3,1),1/Math.hypot(.3,1),0],jI=(2*Math.PI)**2;function Bd(n,e,t){let i=n.body[e];return!i||i.locked||!(i.mass>0)||!Number.isFinite(t)?null:[i.mass*t*ZS[0],i.mass*t*ZS[1],0]}function KS(n,e,t){let i=n.body[e];return!i||i.locked||!Number.isFinite(t)||t===0?null:[0,0,(i.inertia[0]+i.inertia[4]+i.inertia[8])/3*t]}var jS=(n,e)=>(n>0?n:1)*jI*e**2;var QI=9;function QS({viewer:n,scene:e}){let t=(i,r,s,o,a=.01)=>u("label",{children:[r,u("input",{type:"number",class:"number",min:a,step:"any",value:i,onChange:l=>{let c=l.currentTarget.valueAsNumber,h=(c>0||c===a)&&Number.isFinite(c);h&&o(c),l.currentTarget.value=String(h?c:i),n.changed()}}),s]});return u("section",{class:"panel",children:[u("h2",{children:"Kick and pull"}),u("div",{class:"choices",children:[t(n.kickSpeed,"Kick by","m/s",i=>n.kickSpeed=i),t(n.kickSpin,"and spin by","rad/s",i=>n.kickSpin=i,0),t(n.pullFrequency,"Pull at","Hz",i=>n.pullFrequency=i)]}),u("ul",{class:"kicks",children:e.body.slice(0,QI).map((i,r)=>{let s=Bd(e,r,n.kickSpeed);return u("li",{children:[u("button",{type:"button",disabled:!s,title:"with Shift the other way",onClick:o=>n.kick(r,o.shiftKey),children:[u("kbd",{children:r+1})," ",i.name]}),u("span",{class:"muted number",children:s?`${fs(Math.hypot(...s))} N s`:"locked"})]},i.name)})})]})}var eL=4;function tL(n){let e=/^\s*(\d*\.?\d+(?:e[-+]?\d+)?)\s*(?:\/\s*(\d*\.?\d+(?:e[-+]?\d+)?))?\s*$/i.exec(n),t=e?Number(e[1])/Number(e[2]??1):NaN;return Number.isFinite(t)&&t>0}function nL({lane:n,engines:e,name:t,change:i}){let[r,s]=et(n.dt_text),o=e.find(c=>c.id===n.engine)?.integrators??[],a=!tL(r),l=()=>{!a&&r.trim()!==n.dt_text&&i({...n,dt_text:r.trim()})};return u(Oe,{children:[u("select",{"aria-label":`engine of ${t}`,value:n.engine,onChange:c=>i({...n,engine:c.currentTarget.value,integrator:""}),children:[!e.some(c=>c.id===n.engine)&&u("option",{value:n.engine,children:n.engine}),e.map(c=>u("option",{value:c.id,children:[c.id," ",c.version]},c.id))]}),u("select",{"aria-label":`integrator of ${t}`,value:n.integrator,onChange:c=>i({...n,integrator:c.currentTarget.value}),children:[u("option",{value:"",children:"default"}),o.map(c=>u("option",{value:c,children:c},c))]}),u("input",{type:"text",class:"number step","aria-label":`step of ${t} in seconds`,"aria-invalid":a,value:r,onInput:c=>s(c.currentTarget.value),onBlur:l,onKeyDown:c=>c.key==="Enter"&&l()})]})}function eM({viewer:n,session:e}){let{lanes:t,engines:i}=e,r=o=>n.send({do:"lanes",lanes:o}),s=i.find(o=>!t.some(a=>a.engine===o.id))??i[0];return u("section",{class:"panel",children:[u("h2",{children:"Lanes"}),u("p",{class:"muted",children:"Engine, integrator and step [s]; the state is kept."}),u("ol",{class:"lane-list",children:t.map((o,a)=>u("li",{children:[u(nL,{lane:o,engines:i,name:`lane ${a+1}`,change:l=>r(t.map((c,h)=>h===a?l:c))}),u("button",{type:"button",disabled:t.length<2,"aria-label":`remove lane ${a+1}`,onClick:()=>r(t.filter((l,c)=>c!==a)),children:"\xD7"})]},`${a} ${o.engine} ${o.integrator} ${o.dt_text}`))}),u("button",{type:"button",disabled:t.length>=eL||!s,onClick:()=>s&&r([...t,{engine:s.id,integrator:"",dt_text:t[0]?.dt_text??"1/240"}]),children:"Add a lane"})]})}function tM(n){switch(n.do){case"pull":case"speed":return n.do;case"set":return`set ${n.key}`;default:return null}}var Vd=class{constructor(e,t){this.post=e;this.failed=t}post;failed;waiting=[];busy=!1;put(e){let t=this.waiting[this.waiting.length-1],i=tM(e);t&&i!==null&&tM(t)===i&&this.waiting.pop(),this.waiting.push(e)}flush(){if(this.busy)return;let e=this.waiting.shift();e&&(this.busy=!0,this.post(e).catch(t=>this.failed(t instanceof Error?t.message:String(t))).finally(()=>this.busy=!1))}clear(){this.waiting.length=0}};var zd=class{bytes=new Uint8Array(65536);begin=0;end=0;text=new TextDecoder;push(e){this.append(e);let t=[];for(let i=this.next();i;i=this.next())t.push(i);return t}append(e){let t=this.end-this.begin;if(this.end+e.length>this.bytes.length){let i=t+e.length>this.bytes.length?new Uint8Array(2*(t+e.length)):this.bytes;i.set(this.bytes.subarray(this.begin,this.end)),this.bytes=i,[this.begin,this.end]=[0,t]}this.bytes.set(e,this.end),this.end+=e.length}next(){if(this.end-this.begin<8)return null;let e=new DataView(this.bytes.buffer,this.begin,8),[t,i]=[e.getUint32(0,!0),e.getUint32(4,!0)];if(t>67108864||i>268435456||i%4!==0)throw new Error(`the stream is out of step: a header of ${t} and a payload of ${i} bytes`);if(this.end-this.begin<8+t+i)return null;let r=this.begin+8,s=JSON.parse(this.text.decode(this.bytes.subarray(r,r+t))),o=new Float32Array(this.bytes.slice(r+t,r+t+i).buffer);return this.begin+=8+t+i,{message:s,payload:o}}};var nM="cylon-token",iM=n=>n.replace(/^#/,"").split("&"),rM=n=>n.startsWith("token="),sM=n=>iM(n).some(rM);function iL({location:n,history:e}){let t=iM(n.hash),i=t.find(rM);if(i===void 0)return"";let r=t.filter(s=>s!==i).join("&");return e.replaceState(e.state,"",n.pathname+n.search+(r&&`#${r}`)),i.slice(6)}function oM(n){let e=iL(n);try{if(e==="")return n.sessionStorage?.getItem(nM)??"";n.sessionStorage?.setItem(nM,e)}catch{}return e}var rL=(n,e)=>new Promise(t=>{let i=setTimeout(t,1e3*n);e.addEventListener("abort",()=>(clearTimeout(i),t()),{once:!0})}),Hd=class{constructor(e){this.listener=e}listener;token=oM(window);stop=new AbortController;async run(){let e=()=>{sM(location.hash)&&location.reload()};if(addEventListener("hashchange",e,{signal:this.stop.signal}),this.token==="")return this.listener.locked();let t=.25;for(;!this.stop.signal.aborted;){try{let i=await(await this.ask("/api/session")).json(),r=await this.ask("/api/stream");this.listener.session(i),this.listener.connected(!0,""),t=.25,await this.read(r),this.listener.connected(!1,"the server closed the stream")}catch(i){if(this.stop.signal.aborted)return;this.listener.connected(!1,i instanceof Error?i.message:String(i))}await rL(t,this.stop.signal),t=Math.min(2*t,4)}}async read(e){let t=e.body.getReader(),i=new zd;try{for(;;){let{done:r,value:s}=await t.read();if(r)return;for(let o of i.push(s))this.listener.packet(o)}}finally{t.cancel().catch(()=>{})}}async ask(e,t,i="application/json"){let r={"X-Cylon-Token":this.token};t!==void 0&&(r["Content-Type"]=i);let s=await fetch(e,{method:t===void 0?"GET":"POST",headers:r,body:t,signal:this.stop.signal,cache:"no-store"});if(s.ok)return s;if(s.status===403)throw new Error("another server answers here than the one of this page; open the address that `cylon view` printed last");let o=await s.text(),a=o.slice(0,400);try{a=JSON.parse(o).error??a}catch{}throw new Error(a||`${e}: ${s.status}`)}async command(e){await this.ask("/api/command",JSON.stringify(e))}async frame(e,t){await this.ask(`/api/frame?n=${e}`,t,"image/png")}close(){this.stop.abort()}};var aM=n=>n.recording!==""&&!/\.toml$/i.test(n.recording);function sL(n,e,t){let i=e.reduce((l,c)=>l+c.size.width,0),r=24+Math.max(...e.map(l=>l.size.height));(n.width!==i||n.height!==r)&&([n.width,n.height]=[i,r]);let s=n.getContext("2d",{willReadFrequently:!0}),o=getComputedStyle(document.documentElement);s.fillStyle=o.getPropertyValue("--ground").trim()||"#ffffff",s.fillRect(0,0,i,r),s.fillStyle=o.getPropertyValue("--ink").trim()||"#000000",s.font="14px system-ui, sans-serif";let a=0;return e.forEach((l,c)=>{s.fillText(t[c]??"",a+8,17),l.paint(s,a,24),a+=l.size.width}),new Promise((l,c)=>n.toBlob(h=>h?l(h):c(new Error("the picture could not be kept")),"image/png"))}var Gd=class{constructor(e,t,i){this.send=e;this.failed=t;this.slower=i}send;failed;slower;last=-1;busy=!1;stopped=!1;slowed=0;canvas=document.createElement("canvas");reset(){this.last=-1,this.stopped=!1}take(e,t,i,r){let s=Math.floor(e*30+1e-6);this.stopped||i.length===0||s<=this.last||(s>this.last+1&&this.last>=0&&t-this.slowed>700&&(this.slowed=t,this.slower()),!this.busy&&(this.last=s,this.busy=!0,sL(this.canvas,i,r).then(o=>this.send(s,o)).catch(o=>{this.stopped=!0,this.failed(`recording stopped: ${o instanceof Error?o.message:String(o)}`)}).finally(()=>this.busy=!1)))}};var Wd=class{times=[];start=-1;total={frames:0,seconds:0};constructor(){window.cylonFrames=this.total}tick(e){for(this.start<0&&(this.start=e),++this.total.frames,this.total.seconds=(e-this.start)/1e3,this.times.push(e);this.times[0]<e-1e3;)this.times.shift()}get perSecond(){let e=this.times.length;return e<2?0:1e3*(e-1)/(this.times[e-1]-this.times[0])}};var mg=13,Ql=class{constructor(e){this.bodies=e;this.position=new Float32Array(3*e),this.orientation=new Float32Array(4*e),this.velocity=new Float32Array(3*e),this.spin=new Float32Array(3*e)}bodies;position;orientation;velocity;spin;read(e,t){let i=t*this.bodies*mg;if(e.length<i+this.bodies*mg)return!1;for(let r=0;r<this.bodies;++r){let s=i+r*mg;for(let o=0;o<3;++o)this.position[3*r+o]=e[s+o],this.velocity[3*r+o]=e[s+7+o],this.spin[3*r+o]=e[s+10+o];for(let o=0;o<4;++o)this.orientation[4*r+o]=e[s+3+o]}return!0}vector(e,t){return[e[3*t],e[3*t+1],e[3*t+2]]}angularMomentum(e,t){let i=this.orientation,r=[i[4*t],i[4*t+1],i[4*t+2],i[4*t+3]],s=Jt(Ki(r),this.vector(this.spin,t)),o=e.body[t].inertia,a=l=>o[3*l]*s[0]+o[3*l+1]*s[1]+o[3*l+2]*s[2];return Jt(r,[a(0),a(1),a(2)])}},$d=class{largest=new Map;of(e){return this.largest.get(e)??0}impulse=0;see(e){for(let{impulse:t}of e)Number.isFinite(t)&&(this.impulse=Math.max(this.impulse,t))}clear(){this.largest.clear(),this.impulse=0}arrows(e,t,i,r){let s=[];for(let o of i)for(let a=0;a<t.bodies;++a){let l=e.body[a];if(!l||l.locked)continue;let c=o==="angular momentum"?t.angularMomentum(e,a):t.vector(t.velocity,a),h=o==="momentum"?l.mass:1,f=h*Math.hypot(...c);!Number.isFinite(f)||f===0||(f>this.of(o)&&this.largest.set(o,f),s.push({at:t.vector(t.position,a),along:[h*c[0],h*c[1],h*c[2]],kind:o}))}for(let o of s){let a=r/this.of(o.kind);o.along=[a*o.along[0],a*o.along[1],a*o.along[2]]}return s}};var ec=class{constructor(e,t=6e4){this.bodies=e;this.most=Math.max(32,Math.min(1e3,Math.floor(t/Math.max(e,1)))),this.positions=this.room()}bodies;positions;frames=0;most;room(){return new Float32Array(3*this.bodies*this.most)}add(e){let t=3*this.bodies;if(this.frames===this.most){let i=this.most>>1,r=this.room();r.set(this.positions.subarray((this.most-i)*t)),this.positions=r,this.frames=i}this.positions.set(e,this.frames*t),++this.frames}clear(){this.positions=this.room(),this.frames=0}};var Xd=class{constructor(e,t,i,r){this.scene=t;this.picture=hd(e,t,{label:i}),this.pose=new Ql(t.body.length),this.trail=new ec(t.body.length),this.arrowLength=this.reach(),this.picture.onCamera=s=>r.camera(s,this),this.picture.onFrameAll=()=>r.frameAll(),this.picture.onGrab=s=>r.grab(s),this.picture.onPull=s=>r.pull(s),this.picture.onRelease=()=>r.release()}scene;picture;pose;trail;arrowLength;time=-1/0;reach(){let{min:e,max:t}=Ko(this.scene);return .25*Tt(mt(t,e))}setScene(e,t){this.scene=e,t&&(this.picture.replaceScene(e),this.pose=new Ql(e.body.length),this.trail=new ec(e.body.length),this.arrowLength=this.reach(),this.time=-1/0)}read(e,t,i){return this.pose.read(t,i)?(e<this.time&&this.trail.clear(),e!==this.time&&this.trail.add(this.pose.position),this.time=e,!0):!1}get position(){return this.pose.position}update(e,t,i,r,s){let{picture:o,pose:a,scene:l}=this;if(t.status!=="running"||this.time===-1/0)return;o.show("bodies",a,e.t),o.links(i.links),o.trails("bodies",i.trails?this.trail.positions:null,a.bodies,this.trail.frames-1);let c=["velocity","momentum","angular momentum"].filter(h=>i[h]);o.arrows(r.arrows(l,a,c,this.arrowLength)),o.contacts(i.contacts?t.contacts:[],r.impulse),o.pulls(e.pulls.filter(h=>h.body<a.bodies).map(({body:h,pin:f})=>{let d=a.orientation,p=[d[4*h],d[4*h+1],d[4*h+2],d[4*h+3]];return{from:je(a.vector(a.position,h),Jt(p,s.get(h)??[0,0,0])),to:f}}))}dispose(){this.picture.dispose()}};var tc=(n,e)=>typeof n[e]=="string"?n[e]:"",oL=n=>Array.isArray(n.between)?n.between.join(" \u2013 "):"",aL=[{list:"spring",title:n=>`spring ${tc(n,"body")} \u2013 ${tc(n,"to")||"pin"}`,columns:[{name:"stiffness",label:"stiffness",unit:"N/m",least:0},{name:"rest_length",label:"rest length",unit:"m",least:0},{name:"damping",label:"damping",unit:"N s/m",least:0}]},{list:"drag",title:n=>`drag of ${tc(n,"body")}`,columns:[{name:"linear",label:"linear",unit:"kg/s",least:0},{name:"angular",label:"angular",unit:"kg m\xB2/s",least:0},{name:"momentum",label:"momentum",unit:"1/s",least:0}]},{list:"attraction",title:n=>`attraction ${tc(n,"body")} \u2013 ${tc(n,"to")}`,columns:[{name:"strength",label:"strength",unit:"m\xB3/(kg s\xB2)"}]},{list:"water",title:()=>"water",columns:[{name:"level",label:"level",unit:"m"},{name:"buoyancy",label:"buoyancy",unit:"",least:0},{name:"drag",label:"drag",unit:"kg/s",least:0}]},{list:"material",title:n=>`contact ${oL(n)}`,columns:[{name:"restitution",label:"restitution",unit:"",least:0,most:1},{name:"friction",label:"friction",unit:"",least:0}]}];function lM(n){let e=[{key:"gravity",group:"gravity",label:"gravity",unit:"m/s\xB2",value:n.gravity,least:-1/0,most:1/0}];for(let{list:t,title:i,columns:r}of aL)(Array.isArray(n[t])?n[t]:[]).forEach((o,a)=>{for(let{name:l,label:c,unit:h,least:f=-1/0,most:d=1/0}of r)typeof o[l]=="number"&&e.push({key:`${t}.${a}.${l}`,group:i(o),label:c,unit:h,value:o[l],least:f,most:d})});for(let t of n.body)t.locked||e.push({key:`body.${t.name}.mass`,group:"masses",label:t.name,unit:"kg",value:t.mass,least:Number.MIN_VALUE,most:1/0});return e}function cM(n,e){let t=Number(e.trim());return e.trim()===""||!Number.isFinite(t)?{error:"a number, please"}:t<n.least||t>n.most?{error:n.most===1/0?`must be at least ${n.least===Number.MIN_VALUE?"above 0":n.least}`:`must lie in ${n.least} \u2026 ${n.most}`}:{value:t}}function uM(n){return JSON.stringify([n.body.map(e=>[e.name,e.shape,e.color,e.locked,e.position,e.orientation]),n.joint,n.spring.map(e=>[e.body,e.anchor,e.to,e.to_anchor,e.pin]),n.plane,n.water])}var hM=.15,lL=6,qd=class{bounds;limit;radius;constructor(e,t){this.bounds=Ko(e);let i=Math.max(0,...e.body.map(o=>Tt(o.velocity)).filter(Number.isFinite)),r=Math.max(Tt(e.gravity),...e.body.map(o=>Tt(o.gravity??[0,0,0]))),s=i*t+r*t**2/2;this.limit=Math.max(lL*Tt(mt(this.bounds.max,this.bounds.min)),10*s),this.radius=e.body.map(o=>zc(Zo(o)))}include(e){let t=!1,i=Tt(mt(this.bounds.max,this.bounds.min));for(let r=0;r<3*this.radius.length;++r){let s=r%3,o=e[r],a=this.radius[(r-s)/3];!Number.isFinite(o)||Math.abs(o-(this.bounds.min[s]+this.bounds.max[s])/2)>this.limit||o-a>=this.bounds.min[s]&&o+a<=this.bounds.max[s]||(t||(this.bounds={min:[...this.bounds.min],max:[...this.bounds.max]}),t=!0,o-a<this.bounds.min[s]?this.bounds.min[s]=o-a-hM*i:this.bounds.max[s]=o+a+hM*i)}return t}};var cL=200,uL=125,Gi=n=>[n.engine,n.integrator,`step ${li(n.dt_text)}`].filter(e=>e).join(" \xB7 "),Yd=class{session=null;state=null;connected=!1;why="connecting";locked=!1;notice="";shown={velocity:!1,momentum:!1,"angular momentum":!1,trails:!1,contacts:!0,links:!0};kickSpeed=1;kickSpin=0;pullFrequency=1;history=new kd;scale=new $d;rate=new Wd;pictures=new Map;listeners=new Set;anchors=new Map;connection=new Hd({session:e=>this.take(e),packet:e=>this.packet(e),connected:(e,t)=>this.setConnected(e,t),locked:()=>{this.locked=!0,this.changed()}});commands=new Vd(e=>this.connection.command(e),e=>this.tell(e));film=new Gd((e,t)=>this.connection.frame(e,t),e=>this.tell(e),()=>{this.send({do:"speed",value:Math.max(.01,this.speed/1.5)}),this.tell("Pictures were missed: the motion was slowed down for the recording. Reset records from the start.")});fresh=!1;payload=null;reach=null;looks="";camera=null;grabbed=null;told=0;start(){this.connection.run();let e=t=>{this.frame(t),requestAnimationFrame(e)};requestAnimationFrame(e)}subscribe(e){return this.listeners.add(e),()=>this.listeners.delete(e)}changed(){for(let e of this.listeners)e()}tell(e){this.notice=e,this.changed()}setConnected(e,t){this.connected=e,this.why=t,e?this.notice="":this.commands.clear(),this.changed()}take(e){let t=this.session;this.session=e,t||(this.shown={...this.shown,contacts:e.scene.body.length<=cL}),document.title=`${e.title} \u2014 Cylon`;let i=uM(e.scene),r=i!==this.looks;this.looks=i,r&&(this.reach=new qd(e.scene,e.duration));for(let s of this.pictures.values())s.setScene(e.scene,r&&t!==null);t&&t.lanes.map(Gi).join(`
`)!==e.lanes.map(Gi).join(`
`)&&this.history.clear(),this.changed()}packet(e){let{message:t}=e;if(t.type==="session"){this.take(t.session),this.payload=null;return}this.state&&t.t<this.state.t&&this.restarted(),this.state=t,this.payload=e.payload;for(let[i,r]of this.pictures)t.lanes[i]?.status==="running"&&r.read(t.t,e.payload,i)&&this.hold(r.position);for(let i of t.lanes)this.scale.see(i.contacts);this.history.add(t.t,t.lanes),this.fresh=!0}hold(e){if(this.reach?.include(e))for(let t of this.pictures.values())t.picture.frameOn(this.reach.bounds)}restarted(){this.history.clear(),this.scale.clear(),this.film.reset()}frame(e){this.rate.tick(e),this.commands.flush();let{fresh:t}=this;this.fresh=!1,t&&this.draw();for(let s of this.pictures.values())s.picture.render();let{session:i,state:r}=this;if(t&&i&&r?.playing&&aM(i)){let s=[...this.pictures.keys()].sort((o,a)=>o-a);this.film.take(r.t,e,s.map(o=>this.pictures.get(o).picture),s.map(o=>i.lanes[o]?Gi(i.lanes[o]):""))}e-this.told>uL&&(this.told=e,this.changed())}draw(){let{state:e}=this;if(e)for(let[t,i]of this.pictures){let r=e.lanes[t];r&&i.update(e,r,this.shown,this.scale,this.anchors)}}show(e){this.shown={...this.shown,...e},this.draw(),this.changed()}attach(e,t,i){let r=new Xd(t,this.session.scene,i,this.hands);return this.camera&&(r.picture.camera=this.camera),this.reach&&r.picture.frameOn(this.reach.bounds),this.pictures.set(e,r),this.state?.lanes[e]?.status==="running"&&this.payload&&r.read(this.state.t,this.payload,e),this.fresh=!0,()=>{this.pictures.get(e)===r&&this.pictures.delete(e),r.dispose()}}hands={camera:(e,t)=>{this.camera=e;for(let i of this.pictures.values())i!==t&&(i.picture.camera=e)},frameAll:()=>{this.camera=null;for(let e of this.pictures.values())e.picture.frameAll()},grab:({body:e,anchor:t,point:i})=>{this.grabbed={body:e,anchor:t},this.anchors.set(e,t),this.pull(i)},pull:e=>this.pull(e),release:()=>{this.grabbed=null,this.send({do:"release"})}};pull(e){if(!this.grabbed||!this.session)return;let t=this.session.scene.body[this.grabbed.body]?.mass??1;this.send({do:"pull",...this.grabbed,pin:e,stiffness:jS(t,this.pullFrequency)})}send(e){this.notice="",this.commands.put(e)}kick(e,t){let i=t?-1:1,r=this.session&&Bd(this.session.scene,e,i*this.kickSpeed),s=this.session&&KS(this.session.scene,e,i*this.kickSpin);r?this.send({do:"kick",body:e,impulse:r,...s&&{angular_impulse:s}}):this.session&&e<this.session.scene.body.length&&this.tell(`${this.session.scene.body[e].name} cannot be kicked: it is locked`)}get playing(){return this.state?.playing??this.session?.playing??!1}toggle(){this.send({do:this.playing?"pause":"play"})}get speed(){return this.state?.speed??this.session?.speed??1}};function dM({viewer:n,index:e,lane:t,state:i}){let r=Ht(null),s=Gi(t);Rt(()=>n.attach(e,r.current,`Picture of ${s}`),[n,e,s]);let o=n.session?.lanes??[],a=i&&i.status!=="running";return u("figure",{class:a?"lane broken":"lane",children:[u("figcaption",{children:[u(Rr,{style:e}),u("span",{class:"name",children:s}),i?.cpu_per_second!=null&&u("span",{class:"muted number",title:"CPU seconds per simulated second",children:[i.cpu_per_second.toPrecision(2)," CPU s/s"]}),o.length>1&&u("button",{type:"button","aria-label":`remove ${s}`,onClick:()=>n.send({do:"lanes",lanes:o.filter((l,c)=>c!==e)}),children:"\xD7"})]}),u("div",{class:"picture",ref:r}),a&&u("p",{class:"reason",role:"status",children:[u("strong",{children:i.status})," ",i.reason]})]})}function fM({value:n,label:e,check:t,send:i}){let[r,s]=et(null),o=r===null?null:t(r),a=o&&"error"in o?o.error:"",l=()=>{o&&"value"in o&&o.value!==n&&i(o.value),a||s(null)};return u(Oe,{children:[u("input",{type:"number",step:"any",class:"number","aria-label":e,"aria-invalid":a!=="",value:r??String(n),onInput:c=>s(c.currentTarget.value),onChange:l,onBlur:()=>(l(),s(null))}),a!==""&&u("em",{class:"refused",role:"alert",children:a})]})}function hL({viewer:n,parameter:e}){let{key:t,value:i,label:r,unit:s,group:o}=e,a=l=>cM(e,l);return typeof i=="number"?u("label",{class:"field",children:[u("span",{children:r}),u(fM,{value:i,label:`${o}: ${r}`,check:a,send:l=>n.send({do:"set",key:t,value:l})}),u("span",{class:"muted",children:s})]}):u("div",{class:"field vector",role:"group","aria-label":r,children:[i.map((l,c)=>u(fM,{value:l,label:`${r}, ${"xyz"[c]}`,check:a,send:h=>n.send({do:"set",key:t,value:i.map((f,d)=>d===c?h:f)})},c)),u("span",{class:"muted",children:s})]})}function dL(n){let e=new Map;for(let t of lM(n)){let[i]=/^(spring|drag|attraction|water|material)\.\d+/.exec(t.key)??[t.group],r=e.get(i);r?r.push(t):e.set(i,[t])}return[...e.values()]}var Fa=60;function pM({viewer:n,scene:e}){let t=Ue(()=>dL(e),[e]);return u("section",{class:"panel",children:[u("h2",{children:"Scene"}),t.slice(0,Fa).map((i,r)=>u("details",{open:r<3&&i.length<8,children:[u("summary",{children:i[0].group}),i.slice(0,Fa).map(s=>u(hL,{viewer:n,parameter:s},s.key)),i.length>Fa&&u("p",{class:"muted",children:["and ",i.length-Fa," more"]})]},`${r} ${i[0].group}`)),t.length>Fa&&u("p",{class:"muted",children:["and ",t.length-Fa," more groups"]})]})}var mM=170;function fL(n,e,t){let i={stroke:()=>jn("--ink"),grid:{stroke:()=>jn("--line"),width:1},ticks:{stroke:()=>jn("--line"),width:1},font:"12px system-ui, sans-serif",labelFont:"12px system-ui, sans-serif",labelSize:16,labelGap:0};return{width:n,height:mM,legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1},y:{range:(r,s,o)=>JS(s,o)}},axes:[{...i,label:"time [s]",size:30},{...i,label:`[${t}]`,size:(r,s)=>30+7*Math.max(3,...(s??[]).map(o=>o.length)),values:(r,s)=>s.map(o=>String(Number(o.toPrecision(7))))}],series:[{},...e.map((r,s)=>({stroke:()=>jn(Ti(s).color),dash:Ti(s).dash,width:2,points:{show:!1}}))]}}function pL({viewer:n,lanes:e,quantity:t}){let i=Ht(null),[r,s]=et("size"),o=e.map(Gi).join(`
`);Rt(()=>{let h=i.current,f=new Cn(fL(Math.max(h.clientWidth,160),e,Od[t]),[[],...e.map(()=>[])],h),d=null,p=()=>{let{samples:_}=n.history,g=_[_.length-1];g===d&&_.length>0||(d=g,f.setData([n.history.times(),...e.map((v,E)=>n.history.series(E,t,r))]))};p();let m=[n.subscribe(p),Fo(()=>f.redraw())],x=new ResizeObserver(()=>f.setSize({width:Math.max(h.clientWidth,160),height:mM}));return x.observe(h),()=>{for(let _ of m)_();x.disconnect(),f.destroy()}},[n,o,t,r]);let a=n.history.samples[n.history.samples.length-1],l=h=>a?.lanes[h]?fs(n.history.series(h,t,r).at(-1)):"",c=e.map((h,f)=>`${Gi(h)} ${l(f)}`);return u("figure",{class:"rolling",children:[u("figcaption",{children:[t,t!=="energy"&&u("select",{"aria-label":`component of ${t}`,value:r,onChange:h=>s(h.currentTarget.value),children:YS.map(h=>u("option",{value:h,children:h},h))})]}),u("div",{ref:i,role:"img","aria-label":`${t} over time: ${c.join(", ")}`})]})}function gM({viewer:n,lanes:e}){return u("div",{class:"plots",children:qS.map(t=>u(pL,{viewer:n,lanes:e,quantity:t},t))})}var _M=[{quantity:"energy",component:"size",name:"E"},...["momentum","angular momentum"].flatMap(n=>["size","x","y","z"].map(e=>{let t=n==="momentum"?"p":"L";return{quantity:n,component:e,name:e==="size"?`|${t}|`:`${t} ${e}`}}))];function mL(n,e){return!n||n.energy==null||e.energy==null?"\u2013":fs(e.energy-n.energy)}function xM({viewer:n,lanes:e}){let t=n.state?.lanes??[],i=n.history.first?.lanes;return u("div",{class:"wide",tabIndex:0,role:"region","aria-label":"totals",children:u("table",{class:"readout",children:[u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"lane"}),u("th",{scope:"col",children:"contacts"}),u("th",{scope:"col",children:["E \u2212 E\u2080 ",u("span",{class:"muted",children:"[J]"})]}),_M.map(({quantity:r,name:s})=>u("th",{scope:"col",children:[s," ",u("span",{class:"muted",children:["[",Od[r],"]"]})]},s))]})}),u("tbody",{children:e.map((r,s)=>{let o=t[s],a=o?.status==="running";return u("tr",{children:[u("th",{scope:"row",children:[u(Rr,{style:s})," ",Gi(r)]}),u("td",{class:"number",children:o&&a?o.contacts.length:"\u2013"}),u("td",{class:"number",children:o&&a?mL(i?.[s],o):"\u2013"}),_M.map(({quantity:l,component:c,name:h})=>u("td",{class:"number",children:o&&a?fs(pg(o,l,c)):"\u2013"},h))]},`${s} ${Gi(r)}`)})})]})})}var gL=[{name:"velocity",label:"Velocity",key:"V",unit:"m/s"},{name:"momentum",label:"Momentum",key:"M",unit:"kg m/s"},{name:"angular momentum",label:"Angular momentum",key:"L",unit:"kg m\xB2/s"},{name:"trails",label:"Trails",key:"T"},{name:"contacts",label:"Contacts, impulses",key:"C",unit:"N s"},{name:"links",label:"Springs, joints",key:"J"}],_L=(n,e)=>e==="contacts"?n.scale.impulse:n.scale.of(e);function yM({viewer:n}){return u("section",{class:"panel",children:[u("h2",{children:"Show"}),u("div",{class:"choices",children:gL.map(({name:e,label:t,key:i,unit:r})=>u("label",{children:[u("input",{type:"checkbox",checked:n.shown[e],onChange:s=>n.show({[e]:s.currentTarget.checked})}),t," ",u("kbd",{children:i}),r&&n.shown[e]&&u("span",{class:"muted number",children:[" ","longest ",fs(_L(n,e))," ",r]})]},e))})]})}var xL=n=>Math.log10(n),yL=n=>Number((10**n).toPrecision(3));function vM({viewer:n,session:e}){let{state:t,speed:i,playing:r,connected:s}=n,o=t?.t??0,a=n.rate.perSecond;return u("section",{class:"transport","aria-label":"time",children:[u("button",{type:"button",class:"play",disabled:!s,onClick:()=>n.toggle(),children:r?"Pause":"Play"}),u("button",{type:"button",disabled:!s,onClick:()=>n.send({do:"step"}),children:"Step"}),u("button",{type:"button",disabled:!s,onClick:()=>n.send({do:"reset"}),children:"Reset"}),u("label",{class:"speed",children:["Speed",u("input",{type:"range",min:-2,max:2,step:.05,value:xL(i),"aria-valuetext":`${i} simulated seconds per second`,onInput:l=>n.send({do:"speed",value:yL(Number(l.currentTarget.value))})}),u("output",{class:"number",children:[i.toPrecision(3),"\xD7"]})]}),u("p",{class:"clock",children:[u("span",{class:"number",children:["t = ",o.toFixed(4)," s"]}),u("span",{class:"muted",children:[o>e.duration?" past the scenario\u2019s ":" of ",e.duration," s"]})]}),u("p",{class:"rate muted number","data-testid":"rate",children:[a.toFixed(0)," fps \xB7 ",e.scene.body.length," ",e.scene.body.length===1?"body":"bodies"]}),e.recording!==""&&u("p",{class:"recording",children:["\u25CF recording to ",e.recording]})]})}function bM(n){let[,e]=et(0);Rt(()=>n.subscribe(()=>e(t=>t+1)),[n])}function vL({viewer:n}){let{connected:e,locked:t,why:i,notice:r}=n;return u("div",{class:"banners",role:"alert",children:[t&&u("p",{class:"banner gone",children:["This page lacks the secret of the viewer. Open the address that ",u("code",{children:"cylon view"})," printed: it holds the secret."]}),!e&&!t&&u("p",{class:"banner gone",children:["No connection to the server: ",i,". The page tries again by itself."]}),e&&r!==""&&u("p",{class:"banner notice",children:[r,u("button",{type:"button",onClick:()=>n.tell(""),"aria-label":"close this message",children:"\xD7"})]})]})}function SM({viewer:n}){bM(n);let e=Ht(null);Rt(()=>{let r=$S(n,()=>e.current?.open?e.current.close():e.current?.showModal());return addEventListener("keydown",r),()=>removeEventListener("keydown",r)},[n]);let{session:t,state:i}=n;return u(Oe,{children:[u("header",{class:"head",children:[u("h1",{children:t?.title??"Cylon"}),t&&u("details",{class:"story",children:[u("summary",{children:t.scenario}),u("p",{children:t.story})]}),u("button",{type:"button",onClick:()=>e.current?.showModal(),children:["Keys ",u("kbd",{children:"?"})]})]}),u(vL,{viewer:n}),t&&u("main",{class:"viewer",children:[u(vM,{viewer:n,session:t}),u("section",{class:`lanes of-${Math.min(t.lanes.length,4)}`,"aria-label":"pictures",children:t.lanes.map((r,s)=>u(dM,{viewer:n,index:s,lane:r,state:i?.lanes[s]},`${s} ${Gi(r)}`))}),u("div",{class:"numbers",children:[u(xM,{viewer:n,lanes:t.lanes}),u(gM,{viewer:n,lanes:t.lanes})]}),u("aside",{class:"panels","aria-label":"settings",children:[u(yM,{viewer:n}),u(QS,{viewer:n,scene:t.scene}),u(pM,{viewer:n,scene:t.scene}),u(eM,{viewer:n,session:t})]})]}),u(XS,{dialog:e})]})}function MM(n){pc();let e=new Yd;n.replaceChildren(),Xa(u(SM,{viewer:e}),n),e.start()}var bL={report:GS,view:MM},wM=document.getElementById("app"),TM=bL[document.documentElement.dataset.page??""];wM&&TM&&TM(wM);})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
